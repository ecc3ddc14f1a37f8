"""Recordings for other programs: scenes that move for those that show, tables for those that count."""

from gantline.export.gltf import gltf_binary
from gantline.export.lugs import write_lugs
from gantline.export.rerun_file import RerunMissing, write_rerun
from gantline.export.tables import TableError, VariableError, write_csv, write_parquet

__all__ = [
    "RerunMissing",
    "TableError",
    "VariableError",
    "gltf_binary",
    "write_csv",
    "write_lugs",
    "write_parquet",
    "write_rerun",
]
