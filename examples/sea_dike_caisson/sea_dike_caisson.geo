// A caisson on a rubble bed in front of a fill, on loose sand over slanted rock; the sea is on the left. In metres,
// y = 0 is the sea level.
DefineConstant[
  width = {8.0, Name "Section/width of the caisson, m"},
  depth = {7.0, Name "Section/depth of the caisson's foot below the sea, m"},
  crest = {2.0, Name "Section/height of the crest above the sea, m"},
  bed   = {2.0, Name "Section/thickness of the rubble bed, m"}
];

front = 24.0;             // x of the caisson's front
back = front + width;
foot = -depth;
seabed = foot - bed;
reach = 3.0;              // of the rubble bed beyond the caisson

// rock, from left to right
Point(1) = {0, seabed - 7, 0};
Point(2) = {60, seabed - 4, 0};
// sand
Point(3) = {60, seabed, 0};
Point(4) = {back + reach + bed, seabed, 0};
Point(5) = {front - reach - bed, seabed, 0};
Point(6) = {0, seabed, 0};
// rubble bed
Point(7) = {front - reach, foot, 0};
Point(8) = {front, foot, 0};
Point(9) = {back, foot, 0};
Point(10) = {back + reach, foot, 0};
// caisson and fill
Point(11) = {back, crest, 0};
Point(12) = {front, crest, 0};
Point(13) = {60, crest, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {5, 7};
Line(8) = {7, 8};
Line(9) = {8, 9};
Line(10) = {9, 10};
Line(11) = {10, 4};
Line(12) = {9, 11};
Line(13) = {11, 12};
Line(14) = {12, 8};
Line(15) = {3, 13};
Line(16) = {13, 11};

Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};
Curve Loop(2) = {-4, -11, -10, -9, -8, -7};
Plane Surface(2) = {2};
Curve Loop(3) = {9, 12, 13, 14};
Plane Surface(3) = {3};
Curve Loop(4) = {-3, 15, 16, -12, 10, 11};
Plane Surface(4) = {4};

Physical Surface("sand") = {1};
Physical Surface("rubble") = {2};
Physical Surface("caisson") = {3};
Physical Surface("fill") = {4};
Physical Curve("rock") = {1};
Physical Curve("sea_side") = {6};
Physical Curve("land_side") = {2, 15};
Physical Curve("surface") = {5, 7, 8, 14, 13, 16};
