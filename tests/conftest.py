import sys
from pathlib import Path

# Builders that several test modules share (`import sample_lift`).
sys.path.insert(0, str(Path(__file__).parent / "support"))
