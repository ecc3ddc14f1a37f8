"""Recordings as files: their form, what is kept beside them, and whether they hold."""
