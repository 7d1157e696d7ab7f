"""The code keeps to the words of the glossary, and the check of it can fail."""

import ast
from pathlib import Path

import check_words
import pytest
import quote_source

ROOT = Path(__file__).parent.parent


def test_no_name_that_was_given_up_is_used():
    assert list(check_words.violations()) == []


def test_the_check_sees_what_is_named_so():
    source = "class Wish:\n    def hop(self, soon): ...\nits = 1\nfor way in (): ...\n"
    found = {name for _, name in check_words.names_given(ast.parse(source))}
    assert found >= {"Wish", "hop", "soon", "its", "way"}
    old = check_words.old_names(check_words.GLOSSARY.read_text())
    assert {"Wish", "soon", "its"} <= old
    with pytest.raises(ValueError, match="no table"):
        check_words.old_names("# Nothing")


def test_the_architecture_page_shows_the_step():
    page = quote_source.on_page_markdown((ROOT / "docs" / "architecture.md").read_text())
    assert "def step(" in page
    assert "planning.update(" in page
    assert '"""' not in page
    with pytest.raises(LookupError, match="no function"):
        quote_source.quoted(ROOT / "vfguide" / "loop" / "step.py", "stride")
