"""The plan in a lift file: its steps and what they move."""
