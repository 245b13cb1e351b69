# A body with colors at its vertices, and the sizes that quads are to have there: they grow by four
# from left to right.
#
#   painted_body.py BODY.off PAINTED.obj SIZES.txt

import sys

import numpy as np

from style import BLUE, ORANGE, rgb


def main(body_name, painted_name, sizes_name):
    with open(body_name, encoding="utf-8") as lines:
        rows = [line.split() for line in lines if line.strip()]
    number = int(rows[1][0])
    points = np.array(rows[2 : 2 + number], float)
    triangles = [[int(w) + 1 for w in row[1:4]] for row in rows[2 + number :]]
    mixed = np.clip(0.5 + 1.5 * np.sin(3 * (points[:, :1] + points[:, 1:2])), 0, 1)
    colors = mixed * rgb(ORANGE) + (1 - mixed) * rgb(BLUE)
    with open(painted_name, "w", encoding="utf-8") as out:
        for p, c in zip(points, colors):
            print("v", *p, *("%.3f" % x for x in c), file=out)
        for t in triangles:
            print("f", *t, file=out)
    x = points[:, 0]
    np.savetxt(sizes_name, 4 ** ((x - x.min()) / (x.max() - x.min())), fmt="%.6f")


if __name__ == "__main__":
    main(*sys.argv[1:])
