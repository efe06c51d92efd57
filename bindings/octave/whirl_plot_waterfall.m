function handle = whirl_plot_waterfall(result, varargin)
% WHIRL_PLOT_WATERFALL  Draws the lines of all spectra over order and parameter: the darker, the larger.
%   WHIRL_PLOT_WATERFALL(RESULT, STATION) draws those of a station (name or number) down to a thousandth of the largest:
%   forward whirl at orders above 0, backward whirl below.
%   WHIRL_PLOT_WATERFALL(..., 'full', false) draws the spectra of x alone.
%   WHIRL_PLOT_WATERFALL(..., 'highest_order', N) leaves out orders above N.
%   WHIRL_PLOT_WATERFALL(..., 'table', NAME) draws that table, and not the first with spectra.
%
%   Gives the handle; its CData are decimal logarithms of the amplitudes.
%
%   See also WHIRL_PLOT_SPECTRUM.
FIELD = field_names();
[places, options] = arguments_of(varargin, {[]}, struct('full', true, 'highest_order', Inf, 'table', []));
if ~isnumeric(options.highest_order) || numel(options.highest_order) ~= 1 || ~(options.highest_order > 0)
    error('whirl:badInput', 'the option ''highest_order'' is a number above 0');
end
subject = subject_of(result, FIELD.spectrum_lines, 'spectrum', options.table, places{1});
[order, at, amplitude] = spectra_of(subject, is_full(options.full));
kept = find(abs(order) <= options.highest_order & amplitude > 1e-3 * max(amplitude));
% The largest are drawn above all others.
[ignored, rank] = sort(amplitude(kept)); %#ok<ASGLU>
kept = kept(rank);
[axes_handle, held] = begin_figure();
points = 1.5 + mark_size(numel(kept));
handle = scatter(axes_handle, order(kept), at(kept), points^2, log10(amplitude(kept)), 'filled');
pad_values(axes_handle, subject.values, 'YLim');
end_figure(axes_handle, held, order_label(options.full), subject.label);
decade_bar(axes_handle, log10(amplitude(kept)), amplitude_label(subject));
end

function [order, at, amplitude] = spectra_of(subject, full)
% All lines of all points in three columns.
FIELD = field_names();
lines_of = field_of(subject.table, FIELD.spectrum_lines);
count = size(lines_of, 3);
part = @(column) reshape(lines_of(:, subject.index, :, column), [], count);
factors = repmat(subject.lengths * subject.result.case_.attributes.shown_amplitude, 1, count);
order = part(1);
at = repmat(subject.values, 1, count);
amplitude = part(2) .* factors;
if full
    order = [order, -order];
    at = [at, at];
    amplitude = [part(4), part(5)] .* [factors, factors];
end
order = order(:);
at = at(:);
amplitude = amplitude(:);
end

function decade_bar(axes_handle, logarithms, label)
% A colour bar with the amplitudes at its ticks. They are thrice a decade at most.
colours = sequential_colours();
bar = colour_bar(axes_handle, label, flipud(colours));
if isempty(logarithms)
    return
end
limits = [min(logarithms), max(logarithms)];
if limits(1) == limits(2)
    limits = limits + [-0.5, 0.5];
end
set(axes_handle, 'CLim', limits);
decades = floor(limits(1)):ceil(limits(2));
ticks = reshape([10.^decades; 2 * 10.^decades; 5 * 10.^decades], 1, []);
ticks = ticks(log10(ticks) >= limits(1) & log10(ticks) <= limits(2));
names = arrayfun(@(tick) sprintf('%g', tick), ticks, 'UniformOutput', false);
% MATLAB's bar has ticks, Octave's is a pair of axes.
if isprop(bar, 'Ticks')
    set(bar, 'Ticks', log10(ticks), 'TickLabels', names);
else
    set(bar, 'YTick', log10(ticks), 'YTickLabel', names);
end
end
