"""A folder whose one lift file is `lift.yaml` was refused for having no `scenario.yaml`; it was not named."""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import ScenarioError, load_scenario


@pytest.mark.parametrize(
    ("names", "right"),
    [
        ((), "a lift file or its folder is needed"),
        (("lift.yaml",), "did you mean {folder}/lift.yaml?"),
        (("lift.yml", "notes.txt"), "did you mean {folder}/lift.yml?"),
        (("a.yaml", "b.yaml"), "a lift file or its folder is needed"),
    ],
)
def test_the_only_lift_file_of_a_folder_is_named(tmp_path: Path, names: tuple[str, ...], right: str) -> None:
    for name in names:
        (tmp_path / name).touch()
    with pytest.raises(ScenarioError) as found:
        load_scenario(tmp_path)
    said = f"{tmp_path}: is a folder without scenario.yaml; {right.format(folder=tmp_path)}"
    assert str(found.value) == said
