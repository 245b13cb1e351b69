"""Words of messages: each name of C++ in a term or a remedy of the library has words of Python."""

import re

import pytest

from conftest import SOURCE
from seamless import Error, _words

SOURCES = sorted((SOURCE / "include").rglob("*.h")) + sorted((SOURCE / "maps").glob("*.cpp"))
TEXT = {path: path.read_text(encoding="utf-8") for path in SOURCES}
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"(?:\s*"((?:[^"\\]|\\.)*)")*')

# Words of functions and parameters that the module does not have.
OTHERS = ("connection_tolerance", "cell_neighbors", "quantize() makes one", "extract_triangle_soup",
          "std::vector<std::size_t> for polygons", "quad_remesh() makes meshes of quads only")


def strings(text):
    """The literals of a text, with adjacent ones joined."""
    for match in STRING.finditer(text):
        yield "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', match.group()))


def arguments(text):
    """What `term()` and `remedy()` are called with."""
    for match in re.finditer(r"(?<![\w.])(?:internal::)?(?:term|remedy)\(|Message::REMEDY,", text):
        depth, end = 1, match.end()
        while depth > 0 and end < len(text):
            quoted = STRING.match(text, end)
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end = quoted.end() if quoted else end + 1
        yield text[match.end():end]


def is_composed(words, literals):
    """Whether words are a sequence of literals, with numbers in between."""
    reached = {0}
    for i in range(len(words)):
        if i in reached:
            reached.update(i + len(s) for s in literals if words.startswith(s, i))
            reached.update({i + 1} if words[i].isdigit() else ())
    return len(words) in reached


@pytest.mark.parametrize("words", sorted(_words._WORDS))
def test_library_says_it(words):
    literals = {s for text in TEXT.values() for s in strings(text)
                if len(s) > 5 or not re.search(r"\w", s)} - {""}
    assert is_composed(words, literals)


def test_all_names_have_words():
    found = 0
    for path, text in TEXT.items():
        for argument in arguments(text):
            for words in strings(argument):
                if re.search(r"\w_\w|\(\)|\((?:true|false|\d)\)|::", words) and \
                        not any(other in words for other in OTHERS):
                    found += 1
                    assert any(words in ours for ours in _words._WORDS), (path.name, words)
    assert found > 40


def test_words_of_python_are_plain():
    for ours in _words._WORDS.values():
        for words in ours.values() if isinstance(ours, dict) else (ours,):
            assert not re.search(r"::|<|\((?:true|false|\d)\)|_map\b|_number\b|snap_to", words)


class Message:
    def __init__(self, *parts):
        self.parts = lambda: parts


def test_parts():
    told = _words.told(Message(
        ("text", "the edge between ", None), ("element", "vertices", 3), ("text", " and ", None),
        ("element", "", 7), ("text", " is long, as is ", None), ("element", "face", 4),
        ("term", "the rounding_tolerance is", None), ("text", " 0.1", None),
        ("remedy", "raise maximum_number", None), ("text", ", or so", None),
        ("remedy", "scale the map up by grid_scale", None)), "hexahedra")
    assert told == ("the edge between vertices 3 and 7 is long, as is face 4without a number of "
                    "'hexahedra' it may move by 0.1", "raise 'maximum', or so; ask for more by "
                    "'hexahedra'", "vertices 3 and 7")
    # the words depend on the function; a remedy without words is left out
    features = Message(("element", "row", 5), ("term", " of features", None), ("text", " is bad", None),
                       ("remedy", "some features can be released by maximum_feature_loss", None))
    assert _words.told(features, "extract_quads") == ("row 5 of features is bad", None,
                                                      "row 5 of features")
    assert "'feature_loss'" in _words.sentence(features, "quad_remesh")
    assert str(Error(*_words.told(features, "quad_remesh"))) == _words.sentence(features, "quad_remesh")
