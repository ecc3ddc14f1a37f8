"""Stills and films of a recording: PNG and GIF by themselves, MP4 by ffmpeg."""

from __future__ import annotations

import math
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from PIL import Image

from gantline.plot.film import Film
from gantline.replacing import replaced
from gantline.results.recording import Recording

#: Seconds that a film takes if no speed is asked for, and pictures in each of them.
USUAL_LENGTH = 20.0
MP4_RATE = 25.0
GIF_RATE = 10.0
_GIF_WIDTH = 800
_MOST_PICTURES = 20_000


class VideoError(ValueError):
    """A film that cannot be made; the message is a plain sentence."""


class MomentError(ValueError):
    """A moment that is asked for is not within the recording."""


def write_still(recording: Recording, path: Path, time: float | None = None) -> None:
    """Write a picture of one moment as PNG.

    Args:
        recording: Any recording with something to draw.
        path: File to write.
        time: The moment [s], the nearest sample counts; None for the end.

    Raises:
        MomentError: If the moment is not within the recording.
        ValueError: If there is nothing to draw.
        OSError: If it cannot be written there.
    """
    film = Film(recording)
    times = recording.time
    if time is not None and not times[0] <= time <= times[-1]:
        raise MomentError(
            f"{time:g} s is not within the recording, which goes from {times[0]:g} s to {times[-1]:g} s"
        )
    sample = len(times) - 1 if time is None else int(np.argmin(np.abs(times - time)))
    with replaced(path) as trial:
        Image.fromarray(film.picture(sample)).save(trial, format="PNG")


def write_video(recording: Recording, path: Path, speed: float | None = None) -> None:
    """Write a film, by the ending of its name `.mp4` or `.gif`.

    Args:
        recording: Any recording with something to draw.
        path: File to write.
        speed: Simulated seconds in a second of the film; None so that it takes 20 s.

    Raises:
        VideoError: If ffmpeg is missing or fails, the speed is not finite and above zero, or the film would
            be too long.
        ValueError: If there is nothing to draw.
        OSError: If it cannot be written there.
    """
    if speed is not None and not 0.0 < speed < math.inf:
        raise VideoError(f"a speed of {speed:g} is not a finite number above zero")
    is_gif = path.suffix.lower() == ".gif"
    ffmpeg = None if is_gif else _ffmpeg()
    film = Film(recording, _GIF_WIDTH) if is_gif else Film(recording)
    span = float(recording.time[-1] - recording.time[0])
    chosen = speed if speed is not None else max(span / USUAL_LENGTH, 1e-3)
    rate = GIF_RATE if is_gif else MP4_RATE
    if span / chosen * rate > _MOST_PICTURES:
        raise VideoError(
            f"a film at {chosen:g} times real time would have more than {_MOST_PICTURES} pictures"
        )
    pictures = (Image.fromarray(picture) for picture in film.frames(chosen, rate))
    with replaced(path) as trial:
        if ffmpeg is None:
            _gif(pictures, trial, rate)
        else:
            _mp4(ffmpeg, pictures, trial, rate)


def _ffmpeg() -> str:
    found = shutil.which("ffmpeg")
    if found is None:
        raise VideoError(
            "MP4 needs the program ffmpeg, which is not on the path; its packages are called 'ffmpeg' in"
            " Debian, Ubuntu, Homebrew and winget. A film as .gif needs nothing"
        )
    return found


def _gif(pictures: Iterator[Image.Image], path: Path, rate: float) -> None:
    # One palette for all, so that colours do not flicker.
    first = next(pictures).quantize(128, dither=Image.Dither.NONE)
    rest = (one.quantize(palette=first, dither=Image.Dither.NONE) for one in pictures)
    first.save(
        path,
        format="GIF",
        save_all=True,
        append_images=rest,
        duration=round(1000 / rate),
        loop=0,
        optimize=False,
    )


def _mp4(ffmpeg: str, pictures: Iterator[Image.Image], path: Path, rate: float) -> None:
    first = next(pictures)
    command = [
        *(ffmpeg, "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24"),
        *("-s", f"{first.width}x{first.height}", "-r", f"{rate:g}", "-i", "-", "-an"),
        # What every player shows: whole colours are for few, and the index stands at the beginning.
        *("-c:v", "libx264", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4"),
        str(path.absolute()),
    ]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdin is not None and process.stderr is not None
        try:
            process.stdin.write(first.tobytes())
            for picture in pictures:
                process.stdin.write(picture.tobytes())
            process.stdin.close()
        except BrokenPipeError:
            pass  # it says below why it has ended
        said = process.stderr.read().decode("utf-8", "replace").strip().splitlines()
    if process.returncode != 0:
        raise VideoError(f"ffmpeg could not make the film: {said[-1] if said else 'it does not say why'}")
