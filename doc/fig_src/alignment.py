# Alignment: feature edges lie on isocurves, each with one constant coordinate.
#
#   alignment.py COMPUTED.obj SNAPPED.obj OUT.png
#
# The files hold the features as `l` elements; SNAPPED is aligned to them exactly.

import sys

from matplotlib.lines import Line2D

from renderer import Buffer, Camera, visible_pieces
from style import BLUE, GREEN, ORANGE, VERMILLION, np, plt, save, show
from uv_mesh import next_of, read_obj


def feature_halfedges(mesh):
    """Halfedge -> its constant coordinate, for both sides of each feature edge."""
    flat = mesh.uv.reshape(-1, 2)
    result = {}
    for h, (a, b) in enumerate(zip(mesh.source, mesh.target)):
        if frozenset((a, b)) in mesh.features:
            result[h] = int(np.abs(flat[next_of(h)] - flat[h]).argmin())
    return result


def longest_chain(mesh, features):
    """A sequence of feature halfedges in one chart with the same constant coordinate."""
    flat = mesh.uv.reshape(-1, 2)
    after = {}
    for h in features:
        for g in features:
            if (
                mesh.source[g] == mesh.target[h]
                and g != mesh.opposite[h]
                and features[g] == features[h]
                and np.array_equal(flat[g], flat[next_of(h)])
            ):
                after[h] = g
    chains = []
    for h in set(after) - set(after.values()):
        chain = [h]
        while chain[-1] in after:
            chain.append(after[chain[-1]])
        chains.append(chain)
    return max(chains, key=len)


def draw_body(axes, mesh, features, chain):
    camera = Camera((0.35, 1, -0.95), (0, 0, 1), mesh.points.mean(axis=0), 5.9, (820, 560))
    buffer = Buffer(mesh, camera)
    show(axes, buffer.image(np.full(((buffer.face >= 0).sum(), 3), 0.93), is_smooth=False))
    for h in features:
        for piece in visible_pieces(
            buffer, mesh.points[[mesh.source[h], mesh.target[h]]], 0.02, 0.04
        ):
            axes.plot(*piece.T, color=BLUE, lw=4)
    line = camera.project(mesh.points[[mesh.source[h] for h in chain] + [mesh.target[chain[-1]]]])
    axes.plot(*line[:, :2].T, color=ORANGE, lw=3, ls=(0, (2, 2)))
    axes.legend(
        [Line2D([], [], color=BLUE, lw=4), Line2D([], [], color=ORANGE, lw=3, ls=(0, (2, 2)))],
        ["feature edges", "those drawn at the right"],
        loc="upper center",
        bbox_to_anchor=(0.5, 0.02),
        ncol=2,
        frameon=False,
    )


def draw_chain(axes, along, across, factor, color):
    axes.axhline(0, color="#999999", lw=1.2, ls="--")
    axes.plot(along, factor * across, "o-", color=color, lw=2.5, ms=7)
    axes.set_ylim(-1.25, 1.25)
    axes.set_xticks([])
    axes.set_yticks([])


def main(computed_name, snapped_name, out):
    exact, computed = read_obj(snapped_name), read_obj(computed_name)
    features = feature_halfedges(exact)
    chain = longest_chain(exact, features)
    k = features[chain[0]]
    corners = chain + [next_of(chain[-1])]
    figure = plt.figure(figsize=(14, 6.2))
    draw_body(figure.add_axes([0, 0.1, 0.55, 0.88]), exact, features, chain)
    before, after = (m.uv.reshape(-1, 2)[corners] for m in (computed, exact))
    largest = np.abs(before[:, k] - after[0, k]).max()
    print(len(chain), "edges, largest deviation", largest)
    name = "$%s$" % "uv"[k]
    exponent = int(np.floor(np.log10(largest)))
    size = r"$%.0f\cdot 10^{%d}$" % (largest / 10**exponent, exponent)
    for row, (uv, color, text) in enumerate(
        (
            (
                before,
                VERMILLION,
                "Given: along the feature, " + name + " differs\nfrom a constant by up to " + size,
            ),
            (
                after,
                GREEN,
                "Snapped with alignment: " + name + " is the same double\nat all vertices of "
                "the feature",
            ),
        )
    ):
        axes = figure.add_axes([0.59, 0.55 - 0.48 * row, 0.39, 0.27])
        draw_chain(axes, uv[:, 1 - k], uv[:, k] - after[0, k], 1 / largest, color)
        figure.text(0.59, 0.84 - 0.48 * row, text, color=color, va="bottom", linespacing=1.3)
        axes.set_ylabel(name, fontsize=15, rotation=0, labelpad=12)
        axes.set_xlabel("$%s$" % "uv"[1 - k], fontsize=15)
    save(figure, out)


if __name__ == "__main__":
    main(*sys.argv[1:])
