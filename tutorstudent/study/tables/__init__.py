"""Tables: columns, cells, and the formats that they are written in."""
