// One row of svg_picture.h: the surroundings of the largest gap of a branch, before and after.

#ifndef SEAMLESS_SNAPPING_COMMAND_LINE_SVG_GAP_ROW_H
#define SEAMLESS_SNAPPING_COMMAND_LINE_SVG_GAP_ROW_H

#include "svg_view.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

template <typename TriangleMesh, typename HalfedgeUVMap, typename OldHalfedgeUVMap>
class Svg_gap_row
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Face = typename Graph_traits::face_descriptor;
  using Transitions = CGAL::Seamless_snapping::Seam_transitions<TriangleMesh>;

public:
  Svg_gap_row(const TriangleMesh& mesh, OldHalfedgeUVMap old_uv_map, HalfedgeUVMap uv_map,
              const Transitions& transitions, const Cut_branch<TriangleMesh>& branch,
              const Branch_gaps& old_gaps, const Branch_gaps& gaps)
    : m_mesh(mesh), m_old_uv_map(old_uv_map), m_uv_map(uv_map), m_transitions(transitions),
      m_branch(branch), m_old_gaps(old_gaps), m_gaps(gaps)
  { }

  // `y` is the upper end of the row
  void write(std::ostream& os, char letter, double y) const
  {
    const Window shown = window();
    write_window(os, m_old_uv_map, m_old_gaps, shown, {1035, y}, "#e8965a", "#a84400");
    write_window(os, m_uv_map, m_gaps, shown, {1305, y}, "#4dbb9d", "#00664b");

    const auto largest = [](const Branch_gaps& gaps) {
      return gaps.largest == 0 ? "largest gap: 0 (exact)"
                               : "largest gap: " + scientific(gaps.largest);
    };
    os << "<text x=\"1160\" y=\"" << y + 274 << "\" font-size=\"20\" text-anchor=\"middle\">"
       << largest(m_old_gaps) << "</text><text x=\"1430\" y=\"" << y + 274
       << "\" font-size=\"20\" text-anchor=\"middle\">" << largest(m_gaps) << "</text>\n"
       << "<text x=\"1295\" y=\"" << y + 297 << "\" font-size=\"18\" text-anchor=\"middle\" "
          "fill=\"#777\">" << (m_old_gaps.largest == 0 ? std::string() : "gaps drawn "
       + scientific(shown.factor) + " times as large") << "</text>\n"
       << "<text x=\"1010\" y=\"" << y + 25 << "\" font-size=\"26\">" << letter
       << "</text>\n";
  }

private:
  // What is shown of a branch: some edges around the one with the largest gap, in the chart at the
  // second side.
  struct Window
  {
    Vector_uv center;
    double half_width;
    double factor; // of the gaps
  };

  Window window() const
  {
    const auto& halfedges = m_branch.halfedges;
    const std::size_t e = m_old_gaps.edge_of_largest;
    const std::size_t begin = (std::min)(e > 3 ? e - 3 : 0, halfedges.size() - (std::min)(
                                           halfedges.size(), std::size_t(8)));
    const std::size_t end = (std::min)(begin + 8, halfedges.size());
    CGAL::Bbox_2 box;
    double length = 0;
    for(std::size_t i = begin; i < end; ++i) {
      const Halfedge h = opposite(halfedges[i], m_mesh);
      const Vector_uv p = uv(m_uv_map, prev(h, m_mesh)), q = uv(m_uv_map, h);
      length += std::hypot(q[0] - p[0], q[1] - p[1]) / double(end - begin);
      box += CGAL::Bbox_2(p[0], p[1], p[0], p[1]) + CGAL::Bbox_2(q[0], q[1], q[0], q[1]);
    }
    const double side = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    const double largest = m_old_gaps.largest;
    return Window{{(box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2},
                  (std::max)(0.6 * side, 2.2 * length), largest > 0 ? 0.45 * length / largest : 1};
  }

  // The faces at one side of the branch, with the displacement of each corner that lies on it.
  struct Strip
  {
    std::set<Face> faces;
    std::map<Halfedge, Vector_uv> displacements;
  };

  // Of the face's domain, at the target of `h`.
  double angle(Halfedge h) const
  {
    const Vector_uv a = uv(m_uv_map, prev(h, m_mesh)), b = uv(m_uv_map, h),
                    c = uv(m_uv_map, next(h, m_mesh));
    const double x1 = a[0] - b[0], y1 = a[1] - b[1], x2 = c[0] - b[0], y2 = c[1] - b[1];
    return std::abs(std::atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2));
  }

  // Round the two ends of a cut halfedge, on its side, up to the next cut or border. Faces count up
  // to a right angle or a little more: those behind the end of a branch belong to no side.
  void add_to_strip(Halfedge cut, const Vector_uv& at_source, const Vector_uv& at_target,
                    Strip& strip) const
  {
    const double limit = 1.8;
    double sum = 0;
    for(Halfedge c = cut; ; c = opposite(next(c, m_mesh), m_mesh)) {
      if(sum < limit)
        strip.faces.insert(face(c, m_mesh));
      sum += angle(c);
      strip.displacements.emplace(c, at_target);
      if(is_boundary(next(c, m_mesh)) || opposite(next(c, m_mesh), m_mesh) == cut)
        break;
    }
    sum = 0;
    for(Halfedge c = prev(cut, m_mesh); ; c = prev(opposite(c, m_mesh), m_mesh)) {
      if(sum < limit)
        strip.faces.insert(face(c, m_mesh));
      sum += angle(c);
      strip.displacements.emplace(c, at_source);
      if(is_boundary(c) || prev(opposite(c, m_mesh), m_mesh) == prev(cut, m_mesh))
        break;
    }
  }

  Strip strip_of_side(bool second, const Branch_gaps& gaps, double factor) const
  {
    Strip strip;
    const double half = (second ? -0.5 : 0.5) * factor;
    for(std::size_t i = 0; i < m_branch.halfedges.size(); ++i) {
      const Vector_uv at_source = {half * gaps.gaps[i][0][0], half * gaps.gaps[i][0][1]};
      const Vector_uv at_target = {half * gaps.gaps[i][1][0], half * gaps.gaps[i][1][1]};
      if(second)
        add_to_strip(opposite(m_branch.halfedges[i], m_mesh), at_target, at_source, strip);
      else
        add_to_strip(m_branch.halfedges[i], at_source, at_target, strip);
    }
    return strip;
  }

  // Adds the faces next to those of the strip, but for those that the other side has.
  void widen(Strip& strip, const Strip& other) const
  {
    const std::set<Face> narrow = strip.faces;
    for(const Face f : narrow)
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        const Halfedge o = opposite(h, m_mesh);
        if(!is_boundary(h) && other.faces.count(face(o, m_mesh)) == 0)
          strip.faces.insert(face(o, m_mesh));
      }
  }

  // Both sides of the branch in the chart of the second one, each moved by half the enlarged gap.
  template <typename Map>
  void write_window(std::ostream& os, Map map, const Branch_gaps& gaps, const Window& shown,
                    const Vector_uv& corner, const std::string& fill,
                    const std::string& stroke) const
  {
    const double size = 250;
    const View view{shown.center, size / 2 / shown.half_width,
                    {corner[0] + size / 2, corner[1] + size / 2}};
    Strip strips[2] = {strip_of_side(false, gaps, shown.factor),
                       strip_of_side(true, gaps, shown.factor)};
    for(int i = 0; i < 2; ++i) {
      widen(strips[0], strips[1]);
      widen(strips[1], strips[0]);
    }

    os << "<svg x=\"" << corner[0] << "\" y=\"" << corner[1] << "\" width=\"" << size
       << "\" height=\"" << size << "\" viewBox=\"" << corner[0] << ' ' << corner[1] << ' ' << size
       << ' ' << size << "\">\n";
    for(const bool second : {true, false}) {
      const Strip& strip = strips[second ? 1 : 0];
      const int turns = second ? 0 : m_branch.rotation;
      const Vector_uv shift = second ? Vector_uv{0, 0} : gaps.translation;
      const auto position = [&](Halfedge h) {
        Vector_uv u = rotated(uv(map, h), turns);
        const auto found = strip.displacements.find(h);
        for(std::size_t k = 0; k < 2; ++k)
          u[k] += shift[k] + (found == strip.displacements.end() ? 0. : found->second[k]);
        return u;
      };
      write_strip(os, strip, view, corner, size, position, fill);
      write_seam(os, second, view, position, stroke);
    }
    os << "<rect x=\"" << corner[0] << "\" y=\"" << corner[1] << "\" width=\"" << size
       << "\" height=\"" << size << "\" fill=\"none\" stroke=\"#bbb\"/>\n</svg>\n";
  }

  template <typename Position>
  void write_strip(std::ostream& os, const Strip& strip, const View& view, const Vector_uv& corner,
                   double size, const Position& position, const std::string& fill) const
  {
    os << "<path fill=\"" << fill << "\" fill-opacity=\"0.4\" stroke=\"" << fill
       << "\" stroke-opacity=\"0.7\" stroke-width=\"0.8\" d=\"";
    const CGAL::Bbox_2 window(corner[0], corner[1], corner[0] + size, corner[1] + size);
    for(const Face f : strip.faces) {
      std::vector<Vector_uv> triangle;
      CGAL::Bbox_2 box;
      for(const Halfedge h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        triangle.push_back(position(h));
        const Vector_uv p = view(triangle.back());
        box += CGAL::Bbox_2(p[0], p[1], p[0], p[1]);
      }
      if(CGAL::do_overlap(box, window)) {
        write_points(os, triangle, view);
        os << 'Z';
      }
    }
    os << "\"/>\n";
  }

  template <typename Position>
  void write_seam(std::ostream& os, bool second, const View& view, const Position& position,
                  const std::string& stroke) const
  {
    os << "<path fill=\"none\" stroke-width=\"2.2\" stroke-linejoin=\"round\" stroke=\"" << stroke
       << "\" d=\"";
    for(const Halfedge h : m_branch.halfedges) {
      const Halfedge side = second ? opposite(h, m_mesh) : h;
      write_points(os, {position(prev(side, m_mesh)), position(side)}, view);
    }
    os << "\"/>\n";
  }

  bool is_boundary(Halfedge h) const
  {
    return is_chart_boundary(h, m_mesh, m_transitions);
  }

  const TriangleMesh& m_mesh;
  OldHalfedgeUVMap m_old_uv_map;
  HalfedgeUVMap m_uv_map;
  const Transitions& m_transitions;
  const Cut_branch<TriangleMesh>& m_branch;
  const Branch_gaps& m_old_gaps;
  const Branch_gaps& m_gaps;
};

#endif // SEAMLESS_SNAPPING_COMMAND_LINE_SVG_GAP_ROW_H
