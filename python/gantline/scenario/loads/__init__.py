"""Loads, and what they stand on, hang from or are guided by, in a lift file."""
