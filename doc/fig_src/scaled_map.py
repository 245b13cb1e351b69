# The same map in units whose squares number so many on the surface.
#
#   scaled_map.py IN.obj OUT.obj NUMBER

import sys

import numpy as np

from uv_mesh import read_obj, write_obj


def main(given, written, number):
    mesh = read_obj(given)
    a, b = mesh.uv[:, 1] - mesh.uv[:, 0], mesh.uv[:, 2] - mesh.uv[:, 0]
    area = (a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum() / 2
    write_obj(written, mesh.with_uv(np.sqrt(float(number) / area) * mesh.uv))


if __name__ == "__main__":
    main(*sys.argv[1:])
