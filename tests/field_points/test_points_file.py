"""Files of points, and what is refused as one."""

import pytest

from vfguide.field_points.points_file import read_points
from vfguide.files.errors import InputError


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("", 'its first line is "", allowed is "x,y,z,vx,vy,vz,t"'),
        ("x,y,z\n1,2,3\n", 'its first line is "x,y,z", allowed is "x,y,z,vx,vy,vz,t"'),
        ("x,y,z,vx,vy,vz,t\n", "no points, at least one line must follow"),
        ("x,y,z,vx,vy,vz,t\n1,2,3\n", "line 2: 3 values, allowed 7: x,y,z,vx,vy,vz,t"),
        (
            "x,y,z,vx,vy,vz,t\n1,2,3,4,5,6,7\n1,2,fast,4,5,6,7\n",
            'line 3: z = "fast": allowed is a number from -1e+09 to 1e+09',
        ),
        ("x,y,z,vx,vy,vz,t\n1,2,nan,4,5,6,7\n", 'line 2: z = "nan": allowed is a number'),
        ("x,y,z,vx,vy,vz,t\n1,2,3,4,5,6,1e10\n", 'line 2: t = "1e10": allowed is a number'),
    ],
)
def test_files_that_are_no_points_are_refused(tmp_path, text, complaint):
    path = tmp_path / "points.csv"
    path.write_text(text)
    with pytest.raises(InputError) as error:
        read_points(path)
    assert str(error.value).startswith(f"--points {path}: ")
    assert complaint in str(error.value)


def test_bytes_that_are_no_text_are_refused(tmp_path):
    path = tmp_path / "points.csv"
    path.write_bytes(b"\xff\xfe\x00x")
    with pytest.raises(InputError, match="not a CSV file"):
        read_points(path)


def test_blank_lines_spaces_and_a_byte_order_mark_do_no_harm(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("\ufeffx, y, z, vx, vy, vz, t\n\n1, 2, 3, 4, 5, 6, 7\n", encoding="utf-8")
    assert read_points(path).tolist() == [[1, 2, 3, 4, 5, 6, 7]]
