# Colours, fonts and small helpers that all figures share. The colours are those of Okabe and Ito,
# which colour-blind readers can tell apart.

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from PIL import Image  # noqa: E402

BLUE, VERMILLION, GREEN, ORANGE = "#0072b2", "#d55e00", "#009e73", "#e69f00"
SKY, PURPLE, BLACK, GRAY = "#56b4e9", "#cc79a7", "#222222", "#777777"
PALE, PALE_BLUE, PALE_GREEN, PALE_ORANGE = "#f4f1ea", "#dceaf4", "#ddf1e8", "#fbe9d7"

plt.rcParams.update(
    {
        "font.family": "DejaVu Sans",
        "font.size": 13,
        "svg.fonttype": "path",
        "svg.hashsalt": "figures",
        "lines.solid_capstyle": "round",
        "lines.solid_joinstyle": "round",
        "mathtext.fontset": "dejavusans",
    }
)


def rgb(color):
    return np.array(matplotlib.colors.to_rgb(color))


def save(figure, filename):
    """PNG or SVG by the name; without a date, so that the same figure gives the same file."""
    if str(filename).endswith(".svg"):
        figure.savefig(filename, metadata={"Date": None})
        with open(filename) as file:
            lines = [line.rstrip() + "\n" for line in file]
        with open(filename, "w") as file:
            file.writelines(lines)
    else:
        figure.savefig(filename, dpi=110, metadata={"Software": None})
        image = Image.open(filename).convert("RGB")
        # colors of few pixels, such as those of marks, have to stay what they are
        method = Image.Quantize.MAXCOVERAGE
        image.quantize(256, method, kmeans=4, dither=Image.Dither.NONE).save(filename, optimize=True)
    plt.close(figure)


def show(axes, image):
    """An image as the background of axes whose units are its pixels."""
    axes.imshow(image, interpolation="none", aspect="equal")
    axes.set_xlim(0, image.shape[1])
    axes.set_ylim(image.shape[0], 0)
    axes.axis("off")
