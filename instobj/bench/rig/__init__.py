"""Press rigs: plans of presses, the machine that does them, and recordings that grow with them."""
