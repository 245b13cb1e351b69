// Files by their names, "-" for the standard streams. What is written appears under its name when it is
// complete, and not at all otherwise; a file that is replaced keeps its mode and its owner.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_FILES_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_FILES_H

#include <fstream>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

// Throw `Failure` with the reason; to read a file without any text is a failure, too.
std::string read_file(const std::string& filename);
std::ifstream open_file(const std::string& filename); // throws as well
void write_file(const std::string& filename, const std::string& text);

// The same for what `write()` writes, which is called once. What it throws is passed on, and nothing is
// written then, unless to a special file.
void write_file(const std::string& filename, const std::function<void(std::ostream&)>& write);

// Numbers with blanks or line ends between them. Throws `Failure` with the line of what is none.
std::vector<double> read_numbers(const std::string& filename);

// A standard stream, a device, a pipe, or the like: what is written to it goes through it, and its name
// does not tell a format.
bool is_special_file(const std::string& filename);

// What is behind the last point of a name, in lower case: "obj".
std::string suffix_of(const std::string& filename);

// Throws `Failure` if it is the name of a file that only two commands read.
void check_no_tetrahedra(const std::string& filename);

// Throws `Failure` if it is the name of a picture that cannot be written.
void check_picture(const std::string& filename);

// Whether a command may write to its input.
enum class Overwriting { NOT_OFFERED, NOT_ASKED_FOR, ASKED_FOR };

// Throws `Failure` if two of the files that a command writes are one, or one of them is an input and
// may not be; or if one cannot be written, before it is known what to write. Empty names are ignored.
void check_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs,
                   Overwriting overwriting = Overwriting::NOT_OFFERED);

// The text of the .obj file `from`, to be written to `to`: the names of material libraries, which are
// looked for in the folder of the file, lead to where these are.
std::string with_libraries(std::string text, const std::string& from, const std::string& to);

// Where to tell what was done: not where a file goes to.
std::ostream& summary_stream(const std::vector<std::string>& outputs);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_FILES_H
