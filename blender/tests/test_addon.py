"""Tests of the add-on, run by Blender without a screen: blender -b --python test_addon.py

The environment variable SEAMLESS_PROGRAM names the program. Exits with 1 if a test fails.
"""

import importlib.util
import pathlib
import sys
import tempfile
import traceback

import bmesh
import bpy
import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parents[1]
spec = importlib.util.spec_from_file_location("seamless_quads", FOLDER / "seamless_quads" / "__init__.py")
addon = importlib.util.module_from_spec(spec)
sys.modules["seamless_quads"] = addon
spec.loader.exec_module(addon)
addon.register()


def clear():
    bpy.ops.object.select_all(action="DESELECT")
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    for mesh in list(bpy.data.meshes):
        bpy.data.meshes.remove(mesh)
    settings = bpy.context.scene.seamless_quads
    for name in list(settings.keys()):
        settings.property_unset(name)
    return settings


def remesh():
    """The new object."""
    old = bpy.context.object
    unused = [m for m in bpy.data.meshes if m.users == 0]
    temporary = set(pathlib.Path(tempfile.gettempdir()).glob("seamless_*"))
    assert bpy.ops.object.seamless_quads() == {"FINISHED"}
    assert set(pathlib.Path(tempfile.gettempdir()).glob("seamless_*")) == temporary
    new = bpy.context.object
    assert new is not old and old.hide_get() and new.select_get()
    assert [m for m in bpy.data.meshes if m.users == 0] == unused
    return new


def expect_error(words):
    count = len(bpy.data.objects), len(bpy.data.meshes)
    try:
        result = bpy.ops.object.seamless_quads()
    except RuntimeError as error:
        message = str(error)
    else:
        raise AssertionError("no error, but %s" % result)
    assert words in message, message
    assert "--" not in message and "/tmp" not in message, message
    assert (len(bpy.data.objects), len(bpy.data.meshes)) == count
    assert not bpy.context.object.hide_get()


def number_of_parts(mesh):
    parent = list(range(len(mesh.vertices)))

    def root(v):
        while parent[v] != v:
            v = parent[v]
        return v

    for a, b in mesh.edge_keys:
        parent[root(a)] = root(b)
    return len({root(v) for v in range(len(parent))})


def border_edges(mesh):
    count = {}
    for polygon in mesh.polygons:
        for key in polygon.edge_keys:
            count[key] = count.get(key, 0) + 1
    return [key for key, n in count.items() if n == 1]


def all_quads(mesh):
    return all(len(p.vertices) == 4 for p in mesh.polygons)


def test_monkey():
    """With a modifier, materials, texture coordinates, a vertex group, and colors."""
    settings = clear()
    bpy.ops.mesh.primitive_monkey_add(location=(1, 2, 3))
    old = bpy.context.object
    old.modifiers.new("Subdivision", "SUBSURF").levels = 1
    for name in ("red", "blue"):
        old.data.materials.append(bpy.data.materials.new(name))
    for polygon in old.data.polygons:
        polygon.material_index = int(polygon.center.x > 0)
        polygon.use_smooth = True
    group = old.vertex_groups.new(name="up")
    for vertex in old.data.vertices:
        group.add([vertex.index], float(np.clip(vertex.co.z, 0, 1)), "REPLACE")
    colors = old.data.color_attributes.new("paint", "FLOAT_COLOR", "POINT")
    for vertex in old.data.vertices:
        colors.data[vertex.index].color = (*[0.5 + 0.2 * c for c in vertex.co], 1)
    settings.number, settings.use_angle = 3000, False
    new = remesh()
    mesh = new.data
    assert all_quads(mesh) and 1500 < len(mesh.polygons) < 6000, len(mesh.polygons)
    assert new.matrix_world == old.matrix_world and mesh.polygons[0].use_smooth
    assert [m.name for m in mesh.materials] == ["red", "blue"]
    wrong = [p for p in mesh.polygons if abs(p.center.x) > 0.05 and
             p.material_index != int(p.center.x > 0)]
    assert len(wrong) < len(mesh.polygons) / 100, len(wrong)
    assert mesh.uv_layers.active and mesh.uv_layers.active.name == old.data.uv_layers.active.name
    uv = np.empty(2 * len(mesh.loops))
    mesh.uv_layers.active.data.foreach_get("uv", uv)
    assert 0 <= uv.min() and uv.max() <= 1 and uv.std() > 0.1
    errors, painted = [], []
    for vertex in mesh.vertices:
        weight = sum(g.weight for g in vertex.groups)
        errors.append(abs(weight - np.clip(vertex.co.z, 0, 1)))
        painted.append([mesh.color_attributes["paint"].data[vertex.index].color[c] -
                        (0.5 + 0.2 * vertex.co[c]) for c in range(3)])
    assert np.mean(errors) < 0.05 and np.abs(painted).mean() < 0.05, np.mean(errors)


def marked_cube(mark):
    settings = clear()
    bpy.ops.mesh.primitive_cube_add(size=2)
    mesh = bpy.context.object.data
    edit = bmesh.new()
    edit.from_mesh(mesh)
    bmesh.ops.subdivide_edges(edit, edges=edit.edges[:], cuts=7, use_grid_fill=True)
    for edge in edit.edges:
        if all(abs(v.co.z) < 1e-6 for v in edge.verts):  # around the middle
            mark(edge)
    edit.to_mesh(mesh)
    edit.free()
    settings.number = 700
    return settings


def has_loop_in_the_middle(mesh):
    return sum(all(abs(mesh.vertices[v].co.z) < 1e-5 for v in key) for key in mesh.edge_keys) >= 16


def test_cube_with_marked_edges():
    for mark, name in ((lambda e: setattr(e, "seam", True), "use_seams"),
                       (lambda e: setattr(e, "smooth", False), "use_sharp")):
        settings = marked_cube(mark)
        mesh = remesh().data
        assert all_quads(mesh) and has_loop_in_the_middle(mesh)
        corners = [v for v in mesh.vertices if all(abs(abs(c) - 1) < 1e-6 for c in v.co)]
        assert len(corners) == 8
        settings = marked_cube(mark)
        setattr(settings, name, False)
        features = addon.Source(bpy.context.object, bpy.context.evaluated_depsgraph_get())
        assert features.feature_edges(settings) == []
        features.remove()


def test_open_surface():
    """A sheet: its border stays where it is."""
    settings = clear()
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=20, y_subdivisions=20, size=2)
    settings.target, settings.edge_length = "LENGTH", 0.2
    mesh = remesh().data
    assert all_quads(mesh) and 60 < len(mesh.polygons) < 160, len(mesh.polygons)
    for key in border_edges(mesh):
        for v in key:
            assert abs(max(abs(c) for c in mesh.vertices[v].co) - 1) < 1e-6


def test_two_parts():
    settings = clear()
    bpy.ops.mesh.primitive_uv_sphere_add(location=(-2, 0, 0))
    first = bpy.context.object
    bpy.ops.mesh.primitive_torus_add(location=(2, 0, 0))
    first.select_set(True)
    bpy.ops.object.join()
    settings.number = 1500
    mesh = remesh().data
    assert all_quads(mesh) and number_of_parts(mesh) == 2 and not border_edges(mesh)


def test_symmetry_and_density():
    settings = clear()
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=4)
    group = bpy.context.object.vertex_groups.new(name="top")
    for vertex in bpy.context.object.data.vertices:
        group.add([vertex.index], float(vertex.co.z > 0), "REPLACE")
    settings.number, settings.density_group, settings.density_factor = 1500, "top", 3
    settings.symmetry = (True, False, False)
    mesh = remesh().data
    points = {tuple(v.co) for v in mesh.vertices}
    assert {(-x, y, z) for x, y, z in points} == points
    up = sum(p.center.z > 0.2 for p in mesh.polygons)
    assert up > 2 * sum(p.center.z < -0.2 for p in mesh.polygons)


def test_failures():
    settings = clear()
    bpy.ops.mesh.primitive_circle_add(fill_type="NOTHING")
    expect_error("The object has no faces")
    clear()
    bpy.ops.mesh.primitive_plane_add()
    for vertex in bpy.context.object.data.vertices:
        vertex.co = (vertex.index, 0, 0)  # on a line
    expect_error("have no area")
    clear()
    bpy.ops.mesh.primitive_cube_add()
    settings.symmetry = (True, True, False)
    expect_error("one axis only")
    settings.symmetry = (False, False, False)
    settings.target, settings.edge_length = "LENGTH", 50
    expect_error("Edge Length makes less than one quad")


def test_program_is_not_found():
    clear()
    bpy.ops.mesh.primitive_cube_add()
    found, addon.program_path = addon.program_path, lambda context: None
    try:
        expect_error("is not found")
    finally:
        addon.program_path = found


def test_worse_results_are_told():
    """By a program that only writes a square, and ends with status 5."""
    settings = clear()
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "seamless"
        found, addon.program_path = addon.program_path, lambda context: str(program)
        try:
            for message, words in (("3 quads are inverted", "Some quads are inverted"),
                                   ("9 quads are more than twice as many as wanted", "twice as many")):
                program.write_text("#!/bin/sh\nprintf 'v 0 0 0\\nv 1 0 0\\nv 1 1 0\\nv 0 1 0\\nf 1 2 3 4\\n'"
                                   " > \"$3\"\necho \"error: $3: written, but %s\"\nexit 5\n" % message)
                program.chmod(0o755)
                bpy.ops.mesh.primitive_cube_add()
                job = addon.Job(bpy.context, bpy.context.object, settings)
                new, warning = job.finish(bpy.context)
                job.clean()
                assert len(new.data.polygons) == 1 and words in warning, warning
        finally:
            addon.program_path = found


def test_unticked_sharp_edges():
    """The program does not look for sharp edges by itself."""
    settings = clear()
    bpy.ops.mesh.primitive_cube_add()
    settings.number, settings.use_angle = 700, False
    for is_used in (False, True):
        settings.use_angle = is_used
        job = addon.Job(bpy.context, bpy.context.object, settings)
        job.process.wait()
        lines = job.lines()
        job.clean()
        assert any("sharp edge" in line or line.startswith("features:") for line in lines) == is_used, lines


def test_small_parts_are_told():
    settings = clear()
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=4)
    large = bpy.context.object
    bpy.ops.mesh.primitive_ico_sphere_add(radius=0.01, location=(3, 0, 0))
    large.select_set(True)
    bpy.ops.object.join()
    settings.number = 500
    job = addon.Job(bpy.context, bpy.context.object, settings)
    new, warning = job.finish(bpy.context)
    job.clean()
    assert number_of_parts(new.data) == 1
    assert warning == "Left out: 1 small closed part, smaller than a quad; choose more Quads to keep them", \
        warning


def test_words():
    for message, words in (
        ("seamless: --number makes about 20000000 quads, at most 10 million are made; --maximum-number "
         "allows more",
         "Quads makes about 20000000 quads, at most 10 million are made; choose a smaller number of Quads"),
        ("--edge-length makes about 20000000 quads, at most 10 million are made, by --edge-length 0.0123; "
         "--maximum-number allows more",
         "Edge Length makes about 20000000 quads, at most 10 million are made; choose an Edge Length of "
         "0.0123 or more"),
        ("12 of these edges look like noise: --feature-length 0.1 leaves them out, and a larger "
         "--feature-angle keeps fewer",
         "12 of these edges look like noise; choose a larger Angle, or mark fewer edges"),
        ("12 sharp edges kept; --feature-angle 0 keeps none", "12 sharp edges kept"),
        ("border: 5 corners left out, of steps that are smaller than quads; --border-tolerance 0 keeps all",
         "Border: 5 corners left out, of steps that are smaller than quads"),
    ):
        assert addon.in_words(message, "in.obj") == words, addon.in_words(message, "in.obj")


def test_manifest():
    """The rules of Blender 4.2 for extensions, which this Blender need not know."""
    import tomllib
    manifest = tomllib.loads((FOLDER / "seamless_quads" / "blender_manifest.toml").read_text())
    assert {"schema_version", "id", "version", "name", "tagline", "maintainer", "type", "license",
            "blender_version_min"} <= set(manifest)
    assert manifest["schema_version"] == "1.0.0" and manifest["type"] == "add-on"
    assert manifest["id"] == "seamless_quads" and manifest["name"] == addon.bl_info["name"]
    assert manifest["version"] == ".".join(map(str, addon.bl_info["version"]))
    assert manifest["license"] == ["SPDX:GPL-3.0-or-later"]
    assert tuple(map(int, manifest["blender_version_min"].split("."))) >= (4, 2, 0)
    assert set(manifest["permissions"]) <= {"files", "network", "clipboard", "camera", "microphone"}
    for words in [manifest["tagline"], *manifest["permissions"].values()]:
        assert 0 < len(words) <= 64 and words[-1].isalnum(), words


def test_stopping():
    """The program is killed, and its folder removed."""
    settings = clear()
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=7)
    settings.number = 200000
    job = addon.Job(bpy.context, bpy.context.object, settings)
    assert job.is_running() and job.folder.exists()
    job.clean()
    assert not job.is_running() and not job.folder.exists()


failed = 0
for name, test in list(globals().items()):
    if name.startswith("test_"):
        try:
            test()
            print("passed:", name)
        except Exception:
            failed += 1
            traceback.print_exc()
            print("FAILED:", name)
addon.unregister()
print("failed:", failed)
sys.stdout.flush()
sys.exit(1 if failed else 0)
