"""Recordings for other programs: animated glTF for those that show, tables for those that count."""

from gantline.export.gltf import gltf_binary
from gantline.export.tables import TableError, write_csv, write_parquet

__all__ = ["TableError", "gltf_binary", "write_csv", "write_parquet"]
