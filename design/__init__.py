"""What the object is: specification, layouts, solids, mould and export."""
