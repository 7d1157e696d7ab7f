"""The code keeps to the words of the glossary, and the check of it can fail."""

import ast
from pathlib import Path

import check_words
import pytest
import quote_source

ROOT = Path(__file__).parent.parent
GLOSSARY = check_words.GLOSSARY.read_text()


def test_no_name_or_word_that_was_given_up_is_used():
    assert list(check_words.violations()) == []


def test_the_check_sees_what_is_named_so():
    source = (
        "class Wish:\n    def hop(self, soon): ...\nits = 1\nfor way in (): ...\nroute._stand = 0\n"
    )
    found = {name for _, name in check_words.names_given(ast.parse(source))}
    assert found >= {"Wish", "hop", "soon", "its", "way", "_stand"}
    old = check_words.table_under(check_words.NAMES_HEADING, GLOSSARY)
    assert {"Wish", "soon", "its"} <= old
    with pytest.raises(ValueError, match="no table"):
        check_words.table_under(check_words.NAMES_HEADING, "# Nothing")
    with pytest.raises(ValueError, match="no table"):
        check_words.table_under(check_words.WORDS_HEADING, f"{check_words.WORDS_HEADING}\n## More")


def test_the_check_reads_names_docstrings_comments_and_texts():
    words = check_words.table_under(check_words.WORDS_HEADING, GLOSSARY)
    source = '''"""Hops of a detour.

The wishes of a law.
"""
def hop(detourLength):
    """One way out."""
    # no hope for a passer
    its.wish_of = f"{1} ways out, no ways, {'lookout'}"
    return {"episodes": "least bad", "reason": "the least bad"}
'''
    used = sorted(check_words.used_in(check_words.texts(source), words))
    assert used == [
        (1, "detour"),
        (1, "hop"),
        (3, "wish"),
        (5, "detour"),
        (5, "hop"),
        (6, "way out"),
        (7, "passer"),
        (8, "lookout"),
        (8, "no way"),
        (8, "ways out"),
        (8, "wish"),
        (9, "least bad"),
    ]


def test_the_check_reads_the_prose_of_pages_and_templates():
    words = check_words.table_under(check_words.WORDS_HEADING, GLOSSARY)
    page = """A hop, `a hop`, {{ hop.hop }} {% if hop %}
```sh
vfguide --hop
```
that is shut in; who gives way to whom.

## Words that are not used any more

| hop | edge |
"""
    assert list(check_words.used_in(check_words.prose(page), words)) == [(1, "hop"), (5, "shut in")]


def test_a_constant_of_two_modules_is_refused(tmp_path, monkeypatch):
    (tmp_path / "vfguide").mkdir()
    for name, text in (("one", "RATE = 1.0\nMAX_DATAGRAM = 9\n"), ("two", "MAX_DATAGRAM = 9\n")):
        (tmp_path / "vfguide" / f"{name}.py").write_text(text)
    monkeypatch.setattr(check_words, "ROOT", tmp_path)
    assert list(check_words.shared_constants()) == []
    (tmp_path / "vfguide" / "two.py").write_text("\nRATE = 2.0\n")
    (told,) = check_words.shared_constants()
    assert told == "RATE is defined in vfguide/one.py:1 and vfguide/two.py:2"


def test_the_architecture_page_shows_the_step():
    page = quote_source.on_page_markdown((ROOT / "docs" / "architecture.md").read_text())
    assert "def step(" in page
    assert "planning.update(" in page
    assert '"""' not in page
    with pytest.raises(LookupError, match="no function"):
        quote_source.quoted(ROOT / "vfguide" / "loop" / "step.py", "stride")
