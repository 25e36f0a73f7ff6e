"""Room that parts take: boards, pockets, tips, moulds, and the bodies that hold them."""
