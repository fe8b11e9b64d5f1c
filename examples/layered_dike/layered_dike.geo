// A river dike of clay on a blanket of clay over slanted layers of sand, in metres. The land is at y = 0, the
// river on the left.
DefineConstant[
  height  = {5.0, Name "Dike/height, m"},
  crest   = {4.0, Name "Dike/width of the crest, m"},
  slope   = {2.5, Name "Dike/run over rise of the slopes"},
  blanket_river = {2.0, Name "Ground/thickness of the blanket at the river, m"},
  blanket_land  = {3.0, Name "Ground/thickness of the blanket inland, m"},
  loose_river   = {3.0, Name "Ground/thickness of the loose sand at the river, m"},
  loose_land    = {5.0, Name "Ground/thickness of the loose sand inland, m"},
  depth   = {12.0, Name "Ground/depth to rock, m"},
  margin  = {20.0, Name "Ground/width beside the dike, m"}
];
toe = crest / 2 + slope * height;
side = Ceil(toe + margin);
knee = side - 4;  // layers are level beside the sides

Point(1) = {-side, -depth, 0};
Point(2) = {side, -depth, 0};
Point(3) = {side, 0, 0};
Point(4) = {toe, 0, 0};
Point(5) = {crest / 2, height, 0};
Point(6) = {-crest / 2, height, 0};
Point(7) = {-toe, 0, 0};
Point(8) = {-side, 0, 0};

// below the blanket and below the loose sand, from left to right
Point(11) = {-side, -blanket_river, 0};
Point(12) = {-knee, -blanket_river, 0};
Point(13) = {knee, -blanket_land, 0};
Point(14) = {side, -blanket_land, 0};
Point(21) = {-side, -blanket_river - loose_river, 0};
Point(22) = {-knee, -blanket_river - loose_river, 0};
Point(23) = {knee, -blanket_land - loose_land, 0};
Point(24) = {side, -blanket_land - loose_land, 0};

Line(1) = {1, 2};
Line(2) = {2, 24};
Line(3) = {24, 14};
Line(4) = {14, 3};
Line(5) = {3, 4};
Line(6) = {4, 5};
Line(7) = {5, 6};
Line(8) = {6, 7};
Line(9) = {7, 8};
Line(10) = {8, 11};
Line(11) = {11, 21};
Line(12) = {21, 1};
Line(13) = {7, 4};  // between blanket and dike
Line(21) = {11, 12};
Line(22) = {12, 13};
Line(23) = {13, 14};
Line(31) = {21, 22};
Line(32) = {22, 23};
Line(33) = {23, 24};

Curve Loop(1) = {1, 2, -33, -32, -31, 12};
Plane Surface(1) = {1};
Curve Loop(2) = {31, 32, 33, 3, -23, -22, -21, 11};
Plane Surface(2) = {2};
Curve Loop(3) = {21, 22, 23, 4, 5, -13, 9, 10};
Plane Surface(3) = {3};
Curve Loop(4) = {13, 6, 7, 8};
Plane Surface(4) = {4};

Physical Surface("dense") = {1};
Physical Surface("loose") = {2};
Physical Surface("blanket") = {3};
Physical Surface("dike") = {4};
Physical Curve("rock") = {1};
Physical Curve("river_side") = {10, 11, 12};
Physical Curve("land_side") = {2, 3, 4};
Physical Curve("river") = {8, 9};    // slope and bed
Physical Curve("land") = {5, 6, 7};  // ground, slope and crest
