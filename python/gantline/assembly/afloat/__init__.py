"""Vessels, water, waves and wind into bodies and forces."""
