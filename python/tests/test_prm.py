"""Parameter files are changed where they say what is changed, and nowhere else."""

import pytest

from thelma.prm import ParameterText, numbers

TEXT = """# A film.
set Dimension = 2  # plane

subsection Materials
  subsection rubber
    set Shear   modulus = 15 kPa # soft
    set Branches = Maxwell, \\
                   Maxwell
  end
end
"""


def test_reads_entries():
    """With comments, continued lines and runs of blanks."""
    entries = ParameterText(TEXT).entries
    assert entries["Dimension",].value == "2"
    assert entries["Materials", "rubber", "Shear modulus"].value == "15 kPa"
    assert entries["Materials", "rubber", "Shear modulus"].comment == "soft"
    assert entries["Materials", "rubber", "Branches"].value.split() == ["Maxwell,", "Maxwell"]


def test_replaces_where_it_stands():
    """All else stays."""
    text = ParameterText(TEXT)
    text.set("Materials/rubber/Shear modulus", "20 kPa")
    assert str(text) == TEXT.replace("15 kPa # soft", "20 kPa  # soft")
    text.set("Materials/rubber/Branches", "Maxwell")
    assert "set Branches = Maxwell\n  end\n" in str(text)


def test_inserts_what_is_missing():
    """Into sections that are there and others."""
    text = ParameterText(TEXT)
    text.set("Materials/rubber/Permittivity", "4e-5")
    text.set("Materials/foil/Shear modulus", "1 MPa")
    text.set("Loading/Target", "4 kV")
    again = ParameterText(str(text))
    assert again.entries["Materials", "rubber", "Permittivity"].value == "4e-5"
    assert again.entries["Materials", "foil", "Shear modulus"].value == "1 MPa"
    assert again.entries["Loading", "Target"].value == "4 kV"
    assert again.subsections("Materials") == ["rubber", "foil"]


def test_section_to_paste():
    """At the left margin."""
    assert ParameterText(TEXT).section(("Materials", "rubber")) == """subsection rubber
  set Shear   modulus = 15 kPa # soft
  set Branches = Maxwell, \\
                 Maxwell
end
"""


def test_numbers():
    """With what follows them."""
    assert numbers("0.5 kPa, -3.6e-1") == [(0.5, " kPa"), (-0.36, "")]
    with pytest.raises(ValueError):
        numbers("Maxwell")
