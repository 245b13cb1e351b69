// What is written, under locales and rounding modes that programs may have set.

#ifndef SEAMLESS_SNAPPING_TEST_FOREIGN_LOCALES_H
#define SEAMLESS_SNAPPING_TEST_FOREIGN_LOCALES_H

#include "checking.h"

#include <cfenv>
#include <locale>
#include <string>

namespace foreign_locales {

// Needs no locale to be installed.
struct Commas_and_groups : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\1"; }
  std::string do_truename() const override { return "ja"; }
};

// Calls `make_text` under a locale with commas and groups of digits, and in each rounding mode: the
// text is always the same.
template <typename Make_text>
void check_text(const Make_text& make_text, const std::string& context)
{
  const std::string wanted = make_text();
  CHECK_IN(context, !wanted.empty());
  const std::locale foreign(std::locale::classic(), new Commas_and_groups);
  for(const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    const std::locale before = std::locale::global(foreign);
    std::fesetround(mode);
    const std::string text = make_text();
    std::fesetround(FE_TONEAREST);
    std::locale::global(before);
    CHECK_IN(context + ", rounding mode " + std::to_string(mode) + ":\n" +
               text.substr(0, 200) + "\ninstead of\n" + wanted.substr(0, 200), text == wanted);
  }
}

} // namespace foreign_locales

#endif // SEAMLESS_SNAPPING_TEST_FOREIGN_LOCALES_H
