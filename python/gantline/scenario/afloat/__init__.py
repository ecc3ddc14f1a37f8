"""Vessels, water, waves and streams in a lift file."""
