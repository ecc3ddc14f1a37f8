"""`recording.dataset` was one and the same each time. `dataset["rope_tension"] = dataset["rope_tension"] /
1e3`, run twice as cells of notebooks are, divided by a million, and whoever asked for the data set of the
recording later had it so.
"""

from __future__ import annotations

import numpy as np

import gantline


def test_what_is_put_into_a_dataset_is_in_no_other() -> None:
    recording = gantline.simulate("pulleys", duration=0.1)
    given = recording["rope_tension"].values.copy()
    for _ in range(2):
        dataset = recording.dataset
        dataset["rope_tension"] = dataset["rope_tension"] / 1e3
        dataset["half"] = dataset["rope_tension"] / 2
        dataset.attrs["title"] = "mine"
        np.testing.assert_array_equal(dataset["rope_tension"], given / 1e3)
    again = recording.dataset
    np.testing.assert_array_equal(again["rope_tension"], given)
    assert "half" not in again
    assert again.attrs["title"] == recording.title != "mine"


def test_a_dataset_takes_no_copy_of_the_values() -> None:
    recording = gantline.simulate("pulleys", duration=0.1)
    assert np.shares_memory(recording.dataset["rope_tension"].values, recording["rope_tension"].values)
