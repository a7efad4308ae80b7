/**
 * The Python script that Blender runs: reads a mesh, reduces it to a number of triangles, unwraps it, and writes it. Coordinates stay as they are
 * in the files. Arguments after `--`: input (PLY), output (PLY or OBJ), triangles, whether to unwrap (0 or 1). Operators were renamed in
 * Blender 3.3 to 4.1, and the names of axes in 4.0.
 */
export const BLENDER_SCRIPT = `import sys
import bpy

source, target, triangles, unwrap = sys.argv[sys.argv.index("--") + 1:]


def say(text):
    print("scrim: " + text, flush=True)


def run(names, path, *choices):
    for group, name in names:
        operators = getattr(bpy.ops, group)
        if name not in dir(operators):
            continue
        for options in choices or ({},):
            try:
                getattr(operators, name)(filepath=path, **options)
                return
            except TypeError:
                continue
    raise RuntimeError("This Blender cannot use files such as " + path)


bpy.ops.wm.read_factory_settings(use_empty=True)
say("Reading the mesh")
run([("wm", "ply_import"), ("import_mesh", "ply")], source)
meshes = [o for o in bpy.context.scene.objects if o.type == "MESH"]
if not meshes:
    raise RuntimeError("There is no mesh in " + source)
shape = meshes[0]
bpy.context.view_layer.objects.active = shape
shape.select_set(True)
shape.data.calc_loop_triangles()
count = len(shape.data.loop_triangles)
if count > int(triangles):
    say("Simplifying %d triangles" % count)
    change = shape.modifiers.new("fewer", "DECIMATE")
    change.ratio = int(triangles) / count
    change.use_collapse_triangulate = True
    bpy.ops.object.modifier_apply(modifier=change.name)
if unwrap == "1":
    say("Unwrapping")
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.smart_project(island_margin=0.005)
    bpy.ops.object.mode_set(mode="OBJECT")
say("Writing the mesh")
if target.lower().endswith(".obj"):
    run(
        [("wm", "obj_export"), ("export_scene", "obj")],
        target,
        {"export_materials": False, "forward_axis": "Y", "up_axis": "Z"},
        {"export_materials": False, "forward_axis": "Y_FORWARD", "up_axis": "Z_UP"},
        {"use_materials": False, "axis_forward": "Y", "axis_up": "Z"},
    )
else:
    run([("wm", "ply_export"), ("export_mesh", "ply")], target)
`;
