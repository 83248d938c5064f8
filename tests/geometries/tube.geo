// The quarter of a tube with quadratic cells.
Include "../../meshes/tube_quarter_plane.geo";
Mesh.ElementOrder = 2;
