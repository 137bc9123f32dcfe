# What of bench/ the lessons read and draw, in every build that has lessons.
set(report_of_lessons distribution.cpp report.cpp)
set(plots_of_lessons maps.cpp near_edges.cpp plots.cpp prose.cpp rows.cpp)
set(families_of_lessons ray_sphere/families.cpp)
