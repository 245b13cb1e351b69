body.off --genus 1 --sharp --edge-length 0.4
