# Prints a source file as doxygen is to read it where CGAL's tools for its documentation are
# missing: formulas as HTML, so that they need neither LaTeX nor a network; citations and the
# bibliography from biblio.bib; figures with numbers; the manual of each package as a page. A formula
# with a command that is not known here is left alone; doxygen then complains.

use strict;
use warnings;
use utf8;
use open qw(:std :encoding(UTF-8));

my %symbols = (
  pm => '±', ne => '≠', le => '≤', ge => '≥', approx => '≈', cdot => '·', ldots => '…',
  circ => '°', omega => 'ω', sigma => 'σ',
  chi => 'χ', varepsilon => 'ε', det => 'det', quad => '&emsp;', sum => '∑', in => '∈', to => '→',
  log => 'log', times => '×');

# What TeX takes as one argument at the place reached: a group in braces, a command, or a character.
sub argument
{
  my ($tex) = @_;
  return $1 if $$tex =~ /\G\{((?:[^{}]|\{[^{}]*\})*)\}/gc || $$tex =~ /\G(\\[a-z]+|.)/gcs;
  return '';
}

sub html
{
  my ($tex) = @_;
  my $html = '';
  pos($tex) = 0;
  while(pos($tex) < length $tex) {
    if($tex =~ /\G([_^])/gc) {
      my $tag = $1 eq '_' ? 'sub' : 'sup';
      my $what = argument(\$tex);
      $html .= $what eq '\circ' ? '°' : "<$tag>" . html($what) . "</$tag>";
    } elsif($tex =~ /\G\\(mathbf|mathbb|bar) ?/gc) {
      my $font = $1;
      my $what = html(argument(\$tex));
      $html .= $font eq 'mathbf' ? "<b>$what</b>" : $font eq 'bar' ? "$what\x{0304}" : 'ℤ';
    } elsif($tex =~ /\G\\sqrt ?/gc) {
      my $what = html(argument(\$tex));
      $html .= length $what > 1 ? "√($what)" : "√$what";
    } elsif($tex =~ /\G\\\|/gc) {
      $html .= '‖';
    } elsif($tex =~ /\G\\([a-z]+)/gc) {
      die "unknown: \\$1\n" unless defined $symbols{$1};
      $html .= $symbols{$1};
    } elsif($tex =~ /\G([A-Za-z]+)/gc) {
      $html .= "<i>$1</i>";
    } elsif($tex =~ /\G(.)/gcs) {
      $html .= { '*' => '&lowast;', '-' => '−', "'" => '′', "\n" => ' ' }->{$1} // $1;
    }
  }
  return $html;
}

sub formula_or_source
{
  my ($source, $tex) = @_;
  $tex =~ s/^\s+|\s+$//g;
  my $html = eval { html($tex) };
  return defined $html ? "<span class=\"formula\">$html</span>" : $source;
}

my %entries; # key -> label and fields
sub read_bibliography
{
  open my $in, '<', 'biblio.bib' or die "no biblio.bib\n";
  local $/ = undef;
  my $text = <$in>;
  while($text =~ /\@\w+\{\s*([^,\s]+)\s*,(.*?)\n\}/gs) {
    my ($key, $body) = ($1, $2);
    my %entry;
    $entry{$1} = $2 while $body =~ /(\w+)\s*=\s*[{"](.*?)["}]\s*,?\s*(?:\n|$)/g;
    s/[{}]//g for values %entry;
    my @names = map { /([^\s,]+)\s*,/ ? $1 : (split)[-1] } split / and /, $entry{author};
    my $initials = join '', map { substr $_, 0, 1 } @names > 4 ? @names[0 .. 2] : @names;
    $initials .= '+' if @names > 4;
    $entry{label} = $initials . substr $entry{year}, 2;
    $entries{$key} = \%entry;
  }
}

sub cite
{
  my ($key) = @_;
  die "$key is not in biblio.bib\n" unless $entries{$key};
  (my $anchor = $key) =~ s/\W/_/g;
  return "<a href=\"bibliography.html#$anchor\">[$entries{$key}{label}]</a>";
}

sub bibliography
{
  my $result = "<dl class=\"bibliography\">\n";
  for my $key (sort { $entries{$a}{label} cmp $entries{$b}{label} } keys %entries) {
    my %e = %{$entries{$key}};
    (my $anchor = $key) =~ s/\W/_/g;
    (my $authors = $e{author}) =~ s/ and /, /g;
    my $where = $e{journal} || $e{booktitle} || $e{howpublished} || '';
    $result .= "<dt><a name=\"$anchor\"></a>[$e{label}]</dt>\n<dd>$authors. $e{title}.\n";
    $result .= "<em>$where</em>";
    $result .= " $e{volume}" if $e{volume};
    $result .= "($e{number})" if $e{number};
    $result .= ", $e{year}.";
    $result .= " <a href=\"https://doi.org/$e{doi}\">doi:$e{doi}</a>" if $e{doi};
    $result .= "</dd>\n";
  }
  return "$result</dl>";
}

open my $in, '<', $ARGV[0] or die "cannot read $ARGV[0]\n";
my $text = do { local $/ = undef; <$in> };
read_bibliography() if $text =~ /\\cgalCite|\\bibliography/;

# What a package is called, by the description beside its manual.
sub title
{
  (my $description = $ARGV[0]) =~ s/[^\/]*$/PackageDescription.txt/;
  open my $in, '<', $description or die "no $description\n";
  local $/ = undef;
  return <$in> =~ /\\cgalPkgDescriptionBegin\{([^,}]*)/ ? $1 : die "no title in $description\n";
}

$text =~ s/\\mainpage User Manual\s+\\anchor (Chapter_\w+)/"\\page $1 " . title()/e;

my %figures;
$text =~ s/\\cgalFigureBegin\{(\w+),([^}]*)\}/
  $figures{$1} = 1 + keys %figures;
  "<div class=\"figure\"> \\anchor $1\n\\image html $2\n"
  . "<div class=\"caption\"><b>Figure $figures{$1}.<\/b>"/gex;
$text =~ s/\\cgalFigureEnd/<\/div><\/div>/g;
$text =~ s/\\cgalFigureRef\{(\w+)\}/
  "\\ref $1 \"Figure " . ($figures{$1} || die "no figure $1\n") . '"'/gex;
$text =~ s/(\\f\$(.*?)\\f\$)/formula_or_source($1, $2)/gse;
$text =~ s/(\\f\[(.*?)\\f\])/'<center>' . formula_or_source($1, $2) . '<\/center>'/gse;
$text =~ s/\\cgalCite\{([^}]*)\}/cite($1)/ge;
$text =~ s/\\bibliography\b/bibliography()/ge;
print $text;
