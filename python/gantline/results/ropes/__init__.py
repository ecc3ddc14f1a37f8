"""What a recording says of ropes, sheaves and equalizers."""
