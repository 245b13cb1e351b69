# SPDX-License-Identifier: GPL-3.0-or-later
"""An add-on for Blender: remeshes objects with quads by the program `seamless`.

The program runs in a process of its own, which a timer watches: whatever happens there, Blender goes
on, and Esc stops it.
"""

bl_info = {
    "name": "Seamless Quads",
    "description": "Remesh with quads only, along sharp edges and seams",
    "author": "Seamless_snapping",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "3D Viewport > Sidebar > Seamless",
    "category": "Mesh",
}

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import time

import bpy
import numpy as np
from bpy.props import (BoolProperty, BoolVectorProperty, EnumProperty, FloatProperty, IntProperty,
                       PointerProperty, StringProperty)
from mathutils.bvhtree import BVHTree
from mathutils.geometry import barycentric_transform
from mathutils import Vector


# ---- From Blender to a file

class Source:
    """A mesh with modifiers applied, and what hangs on it."""

    def __init__(self, obj, depsgraph):
        evaluated = obj.evaluated_get(depsgraph)
        self.mesh = bpy.data.meshes.new_from_object(evaluated, preserve_all_data_layers=True,
                                                    depsgraph=depsgraph)
        self.group_names = [group.name for group in obj.vertex_groups]

    def remove(self):
        bpy.data.meshes.remove(self.mesh)

    def feature_edges(self, settings):
        """Pairs of vertices: seams, sharp edges, and borders of materials, as the settings ask for."""
        mesh, edges = self.mesh, set()
        for edge in mesh.edges:
            if (settings.use_seams and edge.use_seam) or \
                    (settings.use_sharp and edge.use_edge_sharp):
                edges.add(tuple(edge.vertices))
        if settings.use_materials:
            materials = {}
            for polygon in mesh.polygons:
                for key in polygon.edge_keys:
                    materials.setdefault(key, set()).add(polygon.material_index)
            edges.update(key for key, found in materials.items() if len(found) > 1)
        return sorted({tuple(sorted(edge)) for edge in edges})

    def write_obj(self, path, features):
        mesh = self.mesh
        points = np.empty(3 * len(mesh.vertices), np.float64)
        mesh.vertices.foreach_get("co", points)
        uv = mesh.uv_layers.active.data if mesh.uv_layers.active else None
        with open(path, "w", encoding="utf-8") as file:
            file.writelines("v %r %r %r\n" % tuple(p) for p in points.reshape(-1, 3).tolist())
            if uv is not None:
                values = np.empty(2 * len(uv), np.float64)
                uv.foreach_get("uv", values)
                file.writelines("vt %r %r\n" % tuple(p) for p in values.reshape(-1, 2).tolist())
            material = None
            for polygon in mesh.polygons:
                if polygon.material_index != material:
                    material = polygon.material_index
                    file.write("usemtl %d\n" % material)
                corners = ["%d/%d" % (v + 1, l + 1) if uv is not None else str(v + 1)
                           for v, l in zip(polygon.vertices, polygon.loop_indices)]
                file.write("f %s\n" % " ".join(corners))
            file.writelines("l %d %d\n" % (a + 1, b + 1) for a, b in features)

    def write_sizes(self, path, group_index, factor):
        """Edges are shorter by a factor where the weight in a vertex group is 1."""
        with open(path, "w", encoding="utf-8") as file:
            for vertex in self.mesh.vertices:
                weight = sum(g.weight for g in vertex.groups if g.group == group_index)
                file.write("%r\n" % (factor ** -min(max(weight, 0.), 1.)))


# ---- From a file to Blender

class Result:
    """The quads in a file."""

    def __init__(self, path):
        self.points, self.uv, self.faces, self.corners, self.materials = [], [], [], [], []
        material = 0
        with open(path, encoding="utf-8") as file:
            for line in file:
                words = line.split()
                if not words:
                    continue
                if words[0] == "v":
                    self.points.append([float(w) for w in words[1:4]])
                elif words[0] == "vt":
                    self.uv.append([float(w) for w in words[1:3]])
                elif words[0] == "usemtl":
                    material = int(words[1])
                elif words[0] == "f":
                    parts = [w.split("/") for w in words[1:]]
                    self.faces.append([int(p[0]) - 1 for p in parts])
                    self.corners += [int(p[1]) - 1 if len(p) > 1 and p[1] else -1 for p in parts]
                    self.materials.append(material)

    def mesh(self, name, source):
        """A new mesh, with materials and texture coordinates."""
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(self.points, [], self.faces)
        for material in source.mesh.materials:
            mesh.materials.append(material)
        mesh.polygons.foreach_set("material_index", self.materials)
        if self.uv and source.mesh.uv_layers.active and min(self.corners) >= 0:
            layer = mesh.uv_layers.new(name=source.mesh.uv_layers.active.name)
            layer.data.foreach_set("uv", np.array(self.uv)[self.corners].reshape(-1))
        mesh.update()
        return mesh


class Transfer:
    """Carries weights and colors over from the nearest places of a source."""

    def __init__(self, source):
        mesh = self.source = source.mesh
        mesh.calc_loop_triangles()
        self.triangles = [tuple(t.vertices) for t in mesh.loop_triangles]
        self.loops = [tuple(t.loops) for t in mesh.loop_triangles]
        self.points = [v.co.copy() for v in mesh.vertices]
        self.tree = BVHTree.FromPolygons(self.points, self.triangles)
        self.names = source.group_names

    def place(self, point):
        """The nearest triangle, and barycentric coordinates there."""
        location, _, index, _ = self.tree.find_nearest(point)
        if index is None:
            return None, (0, 0, 0)
        corners = [self.points[v] for v in self.triangles[index]]
        units = [Vector((1, 0, 0)), Vector((0, 1, 0)), Vector((0, 0, 1))]
        weights = barycentric_transform(location, *corners, *units)
        return index, [w if w == w else 1 / 3 for w in weights]

    def add_to(self, obj):
        places = [self.place(v.co) for v in obj.data.vertices]
        self.add_groups(obj, places)
        self.add_colors(obj.data, places)

    def add_groups(self, obj, places):
        groups = [obj.vertex_groups.new(name=name) for name in self.names]
        weights = [{g.group: g.weight for g in v.groups} for v in self.source.vertices]
        for i, (triangle, shares) in enumerate(places):
            if triangle is None:
                continue
            sums = {}
            for v, share in zip(self.triangles[triangle], shares):
                for group, weight in weights[v].items():
                    sums[group] = sums.get(group, 0) + share * weight
            for group, weight in sums.items():
                if weight > 0 and group < len(groups):
                    groups[group].add([i], min(weight, 1.), "REPLACE")

    def add_colors(self, mesh, places):
        for layer in self.source.color_attributes:
            colors = [tuple(item.color) for item in layer.data]
            at = self.triangles if layer.domain == "POINT" else self.loops
            new = mesh.color_attributes.new(layer.name, layer.data_type, "POINT")
            for item, (triangle, shares) in zip(new.data, places):
                if triangle is not None:
                    item.color = [sum(s * colors[c][k] for c, s in zip(at[triangle], shares))
                                  for k in range(4)]


# ---- The program

def program_path(context):
    """The program that the preferences name, or that is found; None without any."""
    addon = context.preferences.addons.get(__package__ or __name__)
    named = addon.preferences.program if addon else ""
    beside = pathlib.Path(__file__).with_name("seamless")
    home = pathlib.Path.home() / ".local" / "bin" / "seamless"
    for candidate in (bpy.path.abspath(named) if named else "", os.environ.get("SEAMLESS_PROGRAM", ""),
                      shutil.which("seamless") or "", str(beside), str(home)):
        if candidate and os.access(candidate, os.X_OK) and os.path.isfile(candidate):
            return candidate
    return None


# What the program says, and what stands for it in the panel. Remedies that the panel lacks come first:
# others take their place, or none.
WORDS = (
    (r", by --edge-length (\S+); --maximum-number allows more", r"; choose an Edge Length of \1 or more"),
    (r"; --maximum-number allows more", "; choose a smaller number of Quads"),
    (r": --feature-length \S+ leaves them out, and a larger --feature-angle keeps fewer",
     "; choose a larger Angle, or mark fewer edges"),
    (r"; --(?:feature-angle|border-tolerance) 0 keeps (?:none|all)", ""),
    (r"^left out: (.*), of area \S+(?: in sum)?; --area-threshold 0 keeps all",
     r"Left out: \1, smaller than a quad; choose more Quads to keep them"),
    (r"closed piece", "closed part"),
    (r"; a larger --number leaves more room for good ones", "; choose more Quads"),
    (r"; more of them(?:, or features, as by --feature-angle,)? keep it",
     "; choose more Quads, or a smaller Angle"),
    (r"--feature-angle(?: [\d.]+)?", "Angle"),
    (r"by a --feature-length of \S+", "because they are short"),
    (r"; 0 keeps them", ""),
    (r"--features", "Seams, Marked Sharp, and Material Borders"),
    (r"--number", "Quads"),
    (r"--edge-length", "Edge Length"),
    (r"--symmetry(?: \S+)?", "Symmetry"),
    (r"--sizes", "Density"),
    (r"--adaptivity", "Adaptivity"),
    (r"--merge(?: [\d.e+-]+| DISTANCE)?", "Mesh > Merge > By Distance"),
    (r"'seamless parametrize'[^;.]*", "other settings"),
)


def in_words(message, path):
    """A message of the program in words of Blender, whose vertices count from 0."""
    message = message.replace(str(path) + ": ", "").replace(str(path), "the object")
    for pattern, words in WORDS:
        message = re.sub(pattern, words, message)
    one_less = lambda m: re.sub(r"\d+", lambda n: str(int(n.group()) - 1), m.group())
    message = re.sub(r"\b(?:vertex \d+|vertices \d+(?:,? (?:and )?\d+)*|face \d+|edge \d+ \d+)", one_less,
                     message)
    message = re.sub(r"^(seamless: |error: )", "", message.strip())
    return message[:1].upper() + message[1:]


class Job:
    """One run of the program on one object."""

    def __init__(self, context, obj, settings):
        program = program_path(context)
        if program is None:
            raise RuntimeError("The program 'seamless' is not found; choose it in Edit > Preferences > "
                               "Add-ons > Seamless Quads")
        self.object, self.smooth = obj, any(p.use_smooth for p in obj.data.polygons)
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="seamless_"))
        self.input, self.output = self.folder / "in.obj", self.folder / "out.obj"
        self.log_path = self.folder / "log.txt"
        self.source = Source(obj, context.evaluated_depsgraph_get())
        self.process = None
        try:
            if len(self.source.mesh.polygons) == 0:
                raise RuntimeError("The object has no faces")
            command = [program, "remesh", str(self.input), str(self.output)]
            command += self.options(settings)
            self.log = open(self.log_path, "w", encoding="utf-8")
            self.process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=self.log,
                                            stderr=subprocess.STDOUT)
        except Exception:
            self.clean()
            raise

    def options(self, settings):
        """Write the files, and return the options of the program."""
        features = self.source.feature_edges(settings)
        self.source.write_obj(self.input, features)
        result = ["--features"] if features else []
        if settings.target == "NUMBER":
            result += ["--number", str(settings.number)]
        else:
            result += ["--edge-length", repr(settings.edge_length)]
        # without the option, the program looks for sharp edges by itself
        result += ["--feature-angle", repr(np.degrees(settings.angle).item() if settings.use_angle else 0.)]
        index = self.object.vertex_groups.find(settings.density_group)
        if index >= 0:
            self.source.write_sizes(self.folder / "sizes.txt", index, settings.density_factor)
            result += ["--sizes", str(self.folder / "sizes.txt")]
        axes = [axis for axis, is_on in zip("xyz", settings.symmetry) if is_on]
        if axes:
            result += ["--symmetry", axes[0]]
        if settings.adaptivity > 1:
            result += ["--adaptivity", repr(settings.adaptivity)]
        return result

    def is_running(self):
        return self.process.poll() is None

    def stop(self):
        if self.is_running():
            self.process.kill()
            self.process.wait()

    def lines(self):
        with open(self.log_path, encoding="utf-8", errors="replace") as file:
            return [line.strip() for line in file if line.strip()]

    def progress(self):
        lines = self.lines()
        return in_words(lines[-1], self.input) if lines else "Starting"

    def finish(self, context):
        """Return the new object and a warning, or raise RuntimeError with what went wrong."""
        status = self.process.wait()
        if status not in (0, 5) or not self.output.exists():
            lines = self.lines()
            raise RuntimeError(in_words(lines[-1], self.input) if status > 0 and lines else
                               "The program 'seamless' has ended unexpectedly; the object is unchanged")
        old = self.object
        try:
            name = old.name
        except ReferenceError:
            raise RuntimeError("The object was removed meanwhile") from None
        result = Result(self.output)
        mesh = result.mesh(old.data.name + " Quads", self.source)
        if self.smooth:
            mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
        new = bpy.data.objects.new(name + " Quads", mesh)
        new.matrix_world = old.matrix_world
        for collection in old.users_collection or [context.scene.collection]:
            collection.objects.link(new)
        Transfer(self.source).add_to(new)
        old.hide_set(True)
        old.select_set(False)
        new.select_set(True)
        context.view_layer.objects.active = new
        notes = [line for line in self.lines() if line.startswith(("left out: ", "note: "))]
        warning = ""
        if status == 5:
            fault = "There are more than twice as many quads as wanted" \
                if any("twice as many" in line for line in self.lines()) \
                else "Some quads are inverted or folded"
            warning = fault + "; choose more Quads, or a larger Angle"
        elif notes:
            warning = in_words(notes[0].replace("note: ", ""), self.input)
        return new, warning

    def clean(self):
        if self.process is not None:
            self.stop()
            self.log.close()
        self.source.remove()
        shutil.rmtree(self.folder, ignore_errors=True)


# ---- What users see

class SEAMLESS_Preferences(bpy.types.AddonPreferences):
    bl_idname = __package__ or __name__

    program: StringProperty(name="Program", subtype="FILE_PATH",
                            description="The program 'seamless'; if empty, it is looked for")

    def draw(self, context):
        self.layout.prop(self, "program")
        found = program_path(context)
        self.layout.label(text=found or "Not found: choose the program above",
                          icon="CHECKMARK" if found else "ERROR")


class SEAMLESS_Settings(bpy.types.PropertyGroup):
    target: EnumProperty(name="Target", items=[
        ("NUMBER", "Quads", "About how many quads to make"),
        ("LENGTH", "Edge Length", "How long to make the edges of the quads")])
    number: IntProperty(name="Quads", default=5000, min=1, soft_max=200000,
                        description="About how many quads to make")
    edge_length: FloatProperty(name="Edge Length", default=0.1, min=1e-6, subtype="DISTANCE",
                               description="How long to make the edges of the quads, in units of the "
                                           "object: apply its scale first")
    use_angle: BoolProperty(name="Sharp Edges", default=True,
                            description="Quads follow edges at which the surface bends by more than the angle")
    angle: FloatProperty(name="Angle", default=np.radians(40).item(), min=0.01,
                         max=np.pi, subtype="ANGLE",
                         description="Edges at which the surface bends by more are kept: 0 is flat, a "
                                     "cube has 90")
    use_seams: BoolProperty(name="Seams", default=True, description="Quads follow seams")
    use_sharp: BoolProperty(name="Marked Sharp", default=True,
                            description="Quads follow edges that are marked as sharp")
    use_materials: BoolProperty(name="Material Borders", default=True,
                                description="Quads follow edges between faces of different materials")
    symmetry: BoolVectorProperty(name="Symmetry", size=3, subtype="XYZ",
                                 description="Mirror one half: the positive side of this axis is kept. One "
                                             "axis only")
    density_group: StringProperty(name="Density", description="Quads are smaller where the weights of "
                                                              "this vertex group are larger")
    density_factor: FloatProperty(name="Factor", default=3, min=1, max=20,
                                  description="How many times shorter edges are where the weight is 1")
    adaptivity: FloatProperty(name="Adaptivity", default=1, min=1, max=10,
                              description="Make quads on flat parts larger than on curved parts, by at "
                                          "most this factor. 1 is off")


class SEAMLESS_OT_remesh(bpy.types.Operator):
    """Remesh the active object with quads; the original is hidden"""
    bl_idname = "object.seamless_quads"
    bl_label = "Remesh with Quads"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "MESH" and \
            context.mode == "OBJECT"

    def start(self, context):
        settings = context.scene.seamless_quads
        if sum(settings.symmetry) > 1:
            self.report({"ERROR"}, "Symmetry by one axis only; choose x, y, or z")
            return False
        try:
            self.job = Job(context, context.object, settings)
        except (RuntimeError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return False
        return True

    def end(self, context):
        try:
            new, warning = self.job.finish(context)
        except RuntimeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            self.job.clean()
        if warning:
            self.report({"WARNING"}, warning)
        self.report({"INFO"}, "%d quads" % len(new.data.polygons))
        return {"FINISHED"}

    def execute(self, context):
        """Without a window: wait for the end."""
        if not self.start(context):
            return {"CANCELLED"}
        while self.job.is_running():
            time.sleep(0.05)
        return self.end(context)

    def invoke(self, context, event):
        if bpy.app.background:
            return self.execute(context)
        if not self.start(context):
            return {"CANCELLED"}
        self.timer = context.window_manager.event_timer_add(0.2, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            self.job.clean()
            self.leave(context)
            self.report({"INFO"}, "Stopped")
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        if self.job.is_running():
            context.workspace.status_text_set("Remeshing, Esc stops: " + self.job.progress())
            return {"RUNNING_MODAL"}
        self.leave(context)
        return self.end(context)

    def leave(self, context):
        context.window_manager.event_timer_remove(self.timer)
        context.workspace.status_text_set(None)


class SEAMLESS_PT_panel(bpy.types.Panel):
    bl_label = "Seamless Quads"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Seamless"

    def draw(self, context):
        settings, layout = context.scene.seamless_quads, self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.row().prop(settings, "target", expand=True)
        layout.prop(settings, "number" if settings.target == "NUMBER" else "edge_length")
        layout.prop(settings, "adaptivity")
        column = layout.column(heading="Keep", align=True)
        column.prop(settings, "use_angle", text="Sharp Edges")
        row = column.row()
        row.active = settings.use_angle
        row.prop(settings, "angle", text="Angle")
        column.prop(settings, "use_seams")
        column.prop(settings, "use_sharp")
        column.prop(settings, "use_materials")
        layout.row(align=True).prop(settings, "symmetry", toggle=True)
        if context.object is not None and context.object.type == "MESH":
            layout.prop_search(settings, "density_group", context.object, "vertex_groups")
            if settings.density_group:
                layout.prop(settings, "density_factor")
        layout.operator(SEAMLESS_OT_remesh.bl_idname, icon="MOD_REMESH")
        if program_path(context) is None:
            layout.label(text="Program not found: choose it in the preferences", icon="ERROR")


CLASSES = (SEAMLESS_Preferences, SEAMLESS_Settings, SEAMLESS_OT_remesh, SEAMLESS_PT_panel)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Scene.seamless_quads = PointerProperty(type=SEAMLESS_Settings)


def unregister():
    del bpy.types.Scene.seamless_quads
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
