function section = section_of(subject, point)
% SECTION_OF  x and y of the station once per revolution at a point: [revolutions][2].
FIELD = field_names();
section = field_of(subject.table, FIELD.poincare_section);
section = subject.lengths(point) * reshape(section(point, subject.index, :, 1:2), [], 2);
end
