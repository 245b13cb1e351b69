# A small renderer: triangles are drawn into a depth buffer that keeps, for each pixel, the face and
# the barycentric coordinates. What is seen is then shaded for all pixels at once, so that isolines
# and checkers are as sharp as the pixels are. Lines are tested against the depth buffer, point by
# point, and never sorted.

import numpy as np


class Camera:
    """A parallel projection that looks along `direction`, with `up` upwards on the picture."""

    def __init__(self, direction, up, center, width, pixels):
        self.back = -np.asarray(direction, float) / np.linalg.norm(direction)
        right = np.cross(up, self.back)
        self.right = right / np.linalg.norm(right)
        self.up = np.cross(self.back, self.right)
        self.center, self.width, self.pixels = np.asarray(center, float), width, pixels
        self.scale = pixels[0] / width

    def project(self, points):
        """Pixel coordinates (x to the right, y downwards) and depth (larger is nearer)."""
        d = np.asarray(points, float) - self.center
        return np.stack(
            [
                d @ self.right * self.scale + self.pixels[0] / 2,
                self.pixels[1] / 2 - d @ self.up * self.scale,
                d @ self.back,
            ],
            axis=-1,
        )


class Buffer:
    def __init__(self, mesh, camera, samples=3):
        """`samples` times `samples` of them a pixel."""
        self.mesh, self.camera, self.samples = mesh, camera, samples
        self.width, self.height = (samples * n for n in camera.pixels)
        self.depth = np.full((self.height, self.width), -np.inf)
        self.face = np.full((self.height, self.width), -1)
        self.weights = np.zeros((self.height, self.width, 3))
        corners = camera.project(mesh.points)[mesh.faces]
        corners[..., :2] *= samples
        for f, triangle in enumerate(corners):
            self._draw(f, triangle)

    def _draw(self, f, triangle):
        (x0, y0), (x1, y1), (x2, y2) = triangle[:, :2]
        area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
        left, right = int(max(triangle[:, 0].min(), 0)), int(
            min(triangle[:, 0].max() + 1, self.width)
        )
        top, bottom = int(max(triangle[:, 1].min(), 0)), int(
            min(triangle[:, 1].max() + 1, self.height)
        )
        if area == 0 or left >= right or top >= bottom:
            return
        x = np.arange(left, right)[None, :] + 0.5
        y = np.arange(top, bottom)[:, None] + 0.5
        w1 = ((x - x0) * (y2 - y0) - (x2 - x0) * (y - y0)) / area
        w2 = ((x1 - x0) * (y - y0) - (x - x0) * (y1 - y0)) / area
        w0 = 1 - w1 - w2
        depth = w0 * triangle[0, 2] + w1 * triangle[1, 2] + w2 * triangle[2, 2]
        window = np.s_[top:bottom, left:right]
        drawn = (w0 >= 0) & (w1 >= 0) & (w2 >= 0) & (depth > self.depth[window])
        self.depth[window][drawn] = depth[drawn]
        self.face[window][drawn] = f
        self.weights[window][drawn] = np.stack([w0, w1, w2], axis=-1)[drawn]

    def interpolated(self, per_corner):
        """Values per corner (faces x 3 x k), at the samples that show a face."""
        shown = self.face >= 0
        return np.einsum("ni,nik->nk", self.weights[shown], per_corner[self.face[shown]])

    def image(self, colors, background=(1, 1, 1), is_smooth=True):
        """Shaded, and averaged over the samples of each pixel. `colors`: of the shown samples."""
        shown = self.face >= 0
        if is_smooth:
            normals = self.interpolated(self.mesh.vertex_normals()[self.mesh.faces])
        else:
            normals = self.mesh.face_normals()[self.face[shown]]
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        c = self.camera
        light = c.back + 0.9 * c.up - 0.5 * c.right
        diffuse = np.abs(normals @ (light / np.linalg.norm(light)))
        half = light / np.linalg.norm(light) + c.back
        shine = np.clip(normals @ (half / np.linalg.norm(half)), 0, 1) ** 40
        samples = np.empty((self.height, self.width, 3))
        samples[:] = background
        samples[shown] = np.clip(
            colors * (0.42 + 0.6 * diffuse)[:, None] + 0.12 * shine[:, None], 0, 1
        )
        n = self.samples
        return samples.reshape(self.height // n, n, self.width // n, n, 3).mean(axis=(1, 3))

    def visible(self, points, slack=0.02):
        """Which points on or near the surface can be seen. `slack`: in units of length."""
        p = self.camera.project(points)
        x = np.clip((p[:, 0] * self.samples).astype(int), 0, self.width - 1)
        y = np.clip((p[:, 1] * self.samples).astype(int), 0, self.height - 1)
        return p[:, 2] >= self.depth[y, x] - slack


def visible_pieces(buffer, polyline, step=0.02, slack=0.02):
    """The visible parts of a polyline in space, as polylines in pixels."""
    dense = [np.asarray(polyline[0], float)]
    for a, b in zip(polyline[:-1], polyline[1:]):
        a, b = np.asarray(a, float), np.asarray(b, float)
        n = max(1, int(np.ceil(np.linalg.norm(b - a) / step)))
        dense.extend(a + (b - a) * i / n for i in range(1, n + 1))
    dense = np.array(dense)
    seen = buffer.visible(dense, slack)
    pixels = buffer.camera.project(dense)[:, :2]
    pieces, piece = [], []
    for p, is_seen in zip(pixels, seen):
        if is_seen:
            piece.append(p)
        elif piece:
            pieces.append(np.array(piece))
            piece = []
    if piece:
        pieces.append(np.array(piece))
    return [piece for piece in pieces if len(piece) > 1]


def gradient_lengths(mesh):
    """Of u and v, on the surface: per face, two numbers."""
    p = mesh.points[mesh.faces]
    e1, e2 = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    d1, d2 = mesh.uv[:, 1] - mesh.uv[:, 0], mesh.uv[:, 2] - mesh.uv[:, 0]
    g11, g12, g22 = ((a * b).sum(axis=1)[:, None] for a, b in ((e1, e1), (e1, e2), (e2, e2)))
    square = (g22 * d1**2 - 2 * g12 * d1 * d2 + g11 * d2**2) / (g11 * g22 - g12**2)
    return np.sqrt(np.maximum(square, 1e-300))


def distance_to_isolines(buffer, uv):
    """On the surface, from each shown sample to the nearest integer isoline of u, and of v."""
    u = buffer.interpolated(uv)
    lengths = gradient_lengths(buffer.mesh)[buffer.face[buffer.face >= 0]]
    return np.abs(u - np.rint(u)) / lengths
