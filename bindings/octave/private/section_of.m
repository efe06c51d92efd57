function section = section_of(subject, point)
% SECTION_OF  x and y of the station once per revolution at a point: [revolutions][2].
section = field_of(subject.table, 'poincare/section');
section = subject.lengths(point) * reshape(section(point, subject.index, :, 1:2), [], 2);
end
