function plane_axes(axes_handle, held, subject, point, path)
% PLANE_AXES  Axes of the plane in which a station moves, alike along x and y and as large as the PATH [points][2] asks,
%   and which point this is.
low = min(path, [], 1);
high = max(path, [], 1);
middle = 0.5 * (low + high);
% A motion that comes back to its place is a point, not what rounding leaves of it.
half = max(0.55 * max(high - low), 1e-3 * max(abs(middle)));
if half > 0 && ~held
    axis(axes_handle, [middle(1) - half, middle(1) + half, middle(2) - half, middle(2) + half]);
end
set(axes_handle, 'DataAspectRatio', [1, 1, 1]);
end_figure(axes_handle, held, length_label(subject.result, ['x of ' subject.station]), ...
    length_label(subject.result, ['y of ' subject.station]), point_title(subject, point));
end
