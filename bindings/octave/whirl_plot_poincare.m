function handle = whirl_plot_poincare(result, varargin)
% WHIRL_PLOT_POINCARE  Draws the Poincare section of a station at a point of a study.
%   WHIRL_PLOT_POINCARE(RESULT, POINT, STATION) draws y over x once per revolution; POINT counts from 1, STATION is a
%   name or a number.
%   WHIRL_PLOT_POINCARE(RESULT, [], STATION, 'at', VALUE) draws the point whose parameter is nearest to a value in SI,
%   or to a text with the unit of the figure: '600 rpm'.
%   WHIRL_PLOT_POINCARE(..., 'table', NAME) draws that table, and not the first with sections.
%
%   Gives the handle.
%
%   See also WHIRL_PLOT_ORBIT, WHIRL_PLOT_BIFURCATION.
FIELD = field_names();
[places, options] = arguments_of(varargin, {[], []}, struct('at', [], 'table', []));
subject = subject_of(result, FIELD.poincare_section, 'poincare', options.table, places{2});
point = point_index(subject, places{1}, options.at);
section = section_of(subject, point);
[axes_handle, held] = begin_figure();
handle = draw_marks(axes_handle, section(:, 1), section(:, 2), 'o', mark_size(size(section, 1)), [0, 0, 0]);
plane_axes(axes_handle, held, subject, point, section);
end
