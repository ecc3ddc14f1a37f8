"""Ways, weight and ends of ropes into mechanics."""
