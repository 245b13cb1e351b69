# A piece of a picture, small.
#
#   thumbnail.py IN.png LEFT TOP RIGHT BOTTOM WIDTH OUT.png

import sys

from PIL import Image


def main(name, *numbers_and_out):
    *box, width = map(int, numbers_and_out[:-1])
    image = Image.open(name).convert("RGB").crop(box)
    height = round(width * image.height / image.width)
    image = image.resize((width, height), Image.LANCZOS).quantize(128, dither=Image.Dither.NONE)
    image.save(numbers_and_out[-1], optimize=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
