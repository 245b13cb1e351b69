// The features of a mesh before a parametrization: which edges of a model are some.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_FEATURE_OPTIONS_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_FEATURE_OPTIONS_H

#include "Model.h"

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

class Options;

struct Marked_features
{
  double length = 0; // of all
  std::size_t number_left_out = 0; // edges
};

// Which edges inside are features, besides those that the file marks.
struct Feature_options
{
  static constexpr double automatic = -1;
  // Edges of parts are mostly sharper, facets of round parts are not.
  static constexpr int detected_angle = 40; // degrees
  double angle = automatic; // in degrees: edges that are sharper
  double length = 0; // of remove_feature_noise()
  bool has_default_length = false; // nobody asked for the length

  // \param keep "keep" or "align", what is done with them
  // \param default_length in words
  void add_to(Options& options, const std::string& keep,
              const std::string& default_length = "0, which leaves out none");

  bool is_automatic() const { return angle == automatic; }

  // Marks them in the model, and tells how many there are; and notes whether most of these look like
  // noise.
  // \param edge_length how long the edges of the quads are to be
  Marked_features mark(double edge_length, Model& model, std::ostream& os) const;
};

// A face can be aligned along two of its edges at most. Returns the edges that are not aligned any
// more.
std::vector<Edge> release_one_of_three(const Mesh& mesh, Edge_bool_map& is_aligned);

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_FEATURE_OPTIONS_H
