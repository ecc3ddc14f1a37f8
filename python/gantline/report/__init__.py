"""The report of a recording: one file that opens in any browser without a network."""

from gantline.report.page import render_live, render_report, write_report

__all__ = ["render_live", "render_report", "write_report"]
