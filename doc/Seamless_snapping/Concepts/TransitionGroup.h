/*!
\ingroup PkgSeamlessSnappingConcepts
\cgalConcept

The concept `TransitionGroup` describes the rotations that transitions between charts may have: a finite
group of integer matrices, and the directions of isocurves. The steps that know no mesh are written for
any such group. They compose elements and never add numbers of turns, and they speak of functionals, not
of coordinates: an isocurve runs where an integer linear form is constant, and the group permutes these
forms up to their signs.

The functions of this version use quarter turns.

\cgalHasModel `CGAL::Seamless_snapping::internal::Rotation_group<N>` for N = 1, 2, 3, 4, and 6. For
N = 1, 2, and 4, coordinates are Cartesian. For N = 3 and 6 they are those of the lattice basis
<em>a + b w</em>, where <em>w</em> is the unit vector at 60 degrees: in Cartesian coordinates
the image of a vector of floating point numbers under a rotation by 60 degrees is not one, as
the square root of 3 is irrational.
*/
class TransitionGroup
{
public:
  /// the dimension of the domain
  static constexpr std::size_t dimension;

  /// the number of elements
  static constexpr int order;

  /// whether all matrices only swap coordinates and change their signs, which no rounding can harm
  static constexpr bool is_signed_permutation;

  /// the number of functionals
  static constexpr int number_of_functionals;

  /// an element of the group; a small integer type
  typedef unspecified_type Element;

  /// a `dimension` by `dimension` array of integers
  typedef unspecified_type Matrix;

  /// returns the neutral element.
  static constexpr Element identity();

  /// returns the element that acts as `h` does, and then `g`.
  static constexpr Element compose(Element g, Element h);

  /// returns the inverse of `g`.
  static constexpr Element inverse(Element g);

  /// returns the element of any number of turns, also a negative one.
  static constexpr Element element(int turns);

  /// returns the least number of turns of an element, from 0 on.
  static constexpr int turns(Element g);

  /// returns the matrix of `g`.
  static constexpr const Matrix& matrix(Element g);

  /// returns the coefficients of functional `f`.
  static constexpr std::array<int, dimension> functional(int f);

  /// returns the coefficients of a linear form after `g`, that is the product of a row and a matrix.
  static constexpr std::array<int, dimension> times_matrix(const std::array<int, dimension>& form,
                                                           Element g);

  /// returns the `index` of the functional `f'` and the `sign` for which
  /// `f'(g u) = sign f(u)`.
  static constexpr unspecified_type act(Element g, int f);

  /// returns the image of a vector.
  template <typename Vector>
  static Vector apply(Element g, const Vector& v);

  /// returns Cartesian coordinates, rounded: for angles and lengths that decide nothing exactly.
  static std::array<double, dimension> to_cartesian(const std::array<double, dimension>& v);
};
