/*!
\ingroup PkgLinearSnappingConcepts
\cgalConcept

The concept `ProgressVisitor` describes the named parameter `visitor` of all functions that may take
long. A function calls its visitor with a line of text after each step, and about once a second within
long steps. The calls are in the thread of the caller, and before the function writes anything. Some
seconds may pass between two calls, for example during the factorization of a large system.

A visitor can throw an exception to stop the function. The exception propagates to the caller, whose
data are as before the call.

\cgalHasModel any function object with this operator, such as a lambda expression or a
`std::function<void(const std::string&)>`, and `std::ref()` of a function object that should not be
copied
*/
class ProgressVisitor
{
public:
  /// receives one line of text, without a line break. The text may change between versions: do not parse it.
  void operator()(const std::string& line);
};
