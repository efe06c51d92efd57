function handle = whirl_plot_orbit(result, varargin)
% WHIRL_PLOT_ORBIT  Draws the orbit of a station at a point of a study that kept waveforms.
%   WHIRL_PLOT_ORBIT(RESULT, POINT, STATION) draws y over x, with a mark at every revolution where sections were taken;
%   POINT counts from 1, STATION is a name or a number. The case must ask for waveforms: analyze: [waveform], keep:
%   {waveform: 20}.
%   WHIRL_PLOT_ORBIT(RESULT, [], STATION, 'at', VALUE) draws the point whose parameter is nearest to a value in SI, as
%   in RESULT.sweep.values, or to a text with the unit of the figure: '600 rpm'.
%   WHIRL_PLOT_ORBIT(..., 'table', NAME) draws that table, and not the first with waveforms.
%
%   Gives the handle of the line, and that of the marks where there are any.
%
%   See also WHIRL_PLOT_POINCARE.
FIELD = field_names();
[places, options] = arguments_of(varargin, {[], []}, struct('at', [], 'table', []));
subject = subject_of(result, FIELD.waveform_samples, 'waveform', options.table, places{2}, true);
point = point_index(subject, places{1}, options.at);
samples = field_of(subject.table, FIELD.waveform_samples);
path = subject.lengths(point) * reshape(samples(point, subject.index, :, 1:2), [], 2);
[axes_handle, held] = begin_figure();
handle = plot(axes_handle, path(:, 1), path(:, 2), 'k-', 'LineWidth', 0.75);
if has_field(subject.table, FIELD.poincare_section)
    % Sections were taken longer than waveforms were kept.
    count = max(1, floor(size(path, 1) / double(subject.table.attributes.samples_per_revolution)));
    marks = section_of(subject, point);
    marks = marks(max(1, end - count + 1):end, :);
    [ignored, colours] = regimes(); %#ok<ASGLU>
    handle = [handle; draw_marks(axes_handle, marks(:, 1), marks(:, 2), 'o', 4, colours(5, :))];
end
plane_axes(axes_handle, held, subject, point, path);
end
