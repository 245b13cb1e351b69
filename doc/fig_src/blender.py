"""The pictures of the add-on for Blender: a monkey, remeshed, beside the panel.

Run in a window of 1280 by 800: blender --factory-startup --enable-event-simulate -p 0 0 1280 800
--python blender.py -- FOLDER_OF_ADDON PICTURE
"""

import importlib.util
import sys

import bpy

bpy.context.preferences.view.show_splash = False
addon_folder, picture = sys.argv[sys.argv.index("--") + 1:]
spec = importlib.util.spec_from_file_location("seamless_quads", addon_folder + "/__init__.py")
addon = importlib.util.module_from_spec(spec)
sys.modules["seamless_quads"] = addon
spec.loader.exec_module(addon)
addon.register()


def make_monkey(view):
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    bpy.ops.mesh.primitive_monkey_add()
    bpy.context.object.modifiers.new("Subdivision", "SUBSURF").levels = 2
    bpy.ops.object.shade_smooth()
    view.show_region_ui = True
    overlay = view.overlay
    overlay.show_wireframes, overlay.wireframe_threshold = True, 1
    overlay.show_floor = overlay.show_axis_x = overlay.show_axis_y = False
    overlay.show_cursor = False
    bpy.context.scene.seamless_quads.number = 3000
    bpy.ops.view3d.view_axis(type="FRONT")
    bpy.ops.view3d.view_orbit(angle=0.5, type="ORBITRIGHT")
    bpy.ops.view3d.view_orbit(angle=0.25, type="ORBITUP")
    bpy.ops.view3d.view_selected()
    view.region_3d.view_distance *= 0.8


def click(window, x, y):
    for kind, value in (("MOUSEMOVE", "NOTHING"), ("LEFTMOUSE", "PRESS"), ("LEFTMOUSE", "RELEASE")):
        window.event_simulate(type=kind, value=value, x=x, y=y)


def steps():
    window = bpy.context.window_manager.windows[0]
    area = next(a for a in window.screen.areas if a.type == "VIEW_3D")
    region = next(r for r in area.regions if r.type == "WINDOW")
    in_view = {"window": window, "area": area, "region": region}
    with bpy.context.temp_override(**in_view):
        make_monkey(area.spaces.active)
    yield
    click(window, 1044, 546)  # the tab of the sidebar
    yield
    with bpy.context.temp_override(**in_view):
        bpy.ops.object.seamless_quads("INVOKE_DEFAULT")
    while not any(obj.name.endswith("Quads") for obj in bpy.data.objects):
        yield
    yield
    with bpy.context.temp_override(**in_view):
        bpy.ops.screen.screenshot(filepath=picture)
    bpy.ops.wm.quit_blender()


all_steps = steps()


def step():
    """The seconds to the next step, or None at the end."""
    for _ in all_steps:
        return 2.0
    return None


bpy.app.timers.register(step, first_interval=2.0)
