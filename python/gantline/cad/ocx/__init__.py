"""OCX files."""
