/*!
\ingroup PkgLinearSnappingConcepts
\cgalConcept

The concept `ProgressVisitor` describes the named parameter `visitor` of all functions that may take
long. A function calls its visitor with a line of text after each step, and about once a second within
long steps. It does so in the thread of the caller, and only before it writes anything. Up to some
seconds may pass between two calls, for example during the factorization of a large system.

A visitor can throw an exception to stop the function. The exception passes on to the caller, whose
data is as before the call.

\cgalHasModel any function object with this operator, such as a lambda expression or a
`std::function<void(const std::string&)>`, and `std::ref()` of a function object that shall not be
copied
*/
class ProgressVisitor
{
public:
  /// receives a line without a line break; a line for people, whose text may change.
  void operator()(const std::string& line);
};
