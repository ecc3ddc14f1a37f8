"""What a recording says of how loads hang, stand and turn."""
