"""The report of a recording: one file that opens in any browser without a network."""

from gantline.report.notebook import Report
from gantline.report.page import render_live, render_notice, render_report, write_report

__all__ = ["Report", "render_live", "render_notice", "render_report", "write_report"]
