"""What can be bought: Hall sensors, magnets, silicones, printers."""
