// QuadriFlow, as Blender has it, run without a window. Meshes go there and come back as OFF files.

#ifndef QUAD_REMESHING_BENCHMARK_QUADRIFLOW_H
#define QUAD_REMESHING_BENCHMARK_QUADRIFLOW_H

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

class Quadriflow
{
public:
  // \param program the name of Blender's
  // \param folder for files that are passed and for its output
  Quadriflow(std::string program, std::filesystem::path folder)
    : m_program(std::move(program)), m_folder(std::move(folder)),
      m_is_there(run("--version"))
  {
    if(m_is_there)
      std::ofstream(m_folder / "quadriflow.py") << script;
  }

  bool is_there() const { return m_is_there; }

  // Writes about so many quads to a file. Returns the seconds of CPU time that this took without
  // reading and writing, or a negative number where it has failed or takes more than three minutes,
  // after which the system ends it.
  double remesh(const std::filesystem::path& mesh, const std::filesystem::path& quads,
                const std::size_t number, const bool has_features) const
  {
    const std::filesystem::path time = m_folder / "quadriflow_seconds.txt";
    std::filesystem::remove(time);
    double seconds = -1;
    if(run("--background --factory-startup --python " + quoted(m_folder / "quadriflow.py") +
           " -- " + quoted(mesh) + " " + quoted(quads) + " " + std::to_string(number) +
           (has_features ? " 1 " : " 0 ") + quoted(time)))
      std::ifstream(time) >> seconds;
    return seconds;
  }

private:
  static constexpr const char* script = R"(
import bpy, resource, sys, time
most_seconds = 180
resource.setrlimit(resource.RLIMIT_CPU, (most_seconds, most_seconds))
source, goal, number, is_sharp, seconds = sys.argv[sys.argv.index("--") + 1:]
words = iter(open(source).read().split()[1:])
counts = [int(next(words)) for _ in range(3)]
points = [[float(next(words)) for _ in range(3)] for _ in range(counts[0])]
faces = [[int(next(words)) for _ in range(int(next(words)))] for _ in range(counts[1])]
mesh = bpy.data.meshes.new("mesh")
mesh.from_pydata(points, [], faces)
body = bpy.data.objects.new("mesh", mesh)
bpy.context.scene.collection.objects.link(body)
bpy.context.view_layer.objects.active = body
body.select_set(True)
begin = time.process_time()
result = bpy.ops.object.quadriflow_remesh(
    mode="FACES", target_faces=int(number), use_preserve_sharp=is_sharp == "1",
    use_preserve_boundary=True, seed=0)
end = time.process_time()
quads = body.data
if result == {"FINISHED"} and all(len(p.vertices) == 4 for p in quads.polygons):
    with open(goal, "w") as out:
        print("OFF\n%d %d 0" % (len(quads.vertices), len(quads.polygons)), file=out)
        for v in quads.vertices:
            print("%.9g %.9g %.9g" % tuple(v.co), file=out)
        for p in quads.polygons:
            print(4, *p.vertices, file=out)
    open(seconds, "w").write(str(end - begin))
)";

  static std::string quoted(const std::filesystem::path& path)
  { return '"' + path.string() + '"'; }

  bool run(const std::string& arguments) const
  {
    const std::string command = '"' + m_program + "\" " + arguments + " > " +
                                quoted(m_folder / "blender.log") + " 2>&1";
    return std::system(command.c_str()) == 0;
  }

  std::string m_program;
  std::filesystem::path m_folder;
  bool m_is_there;
};

#endif // QUAD_REMESHING_BENCHMARK_QUADRIFLOW_H
