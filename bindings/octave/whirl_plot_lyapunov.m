function handle = whirl_plot_lyapunov(result, varargin)
% WHIRL_PLOT_LYAPUNOV  Draws the largest Lyapunov exponent over the parameter, with its error.
%   WHIRL_PLOT_LYAPUNOV(RESULT) draws points in the colours of their regimes, with bars of one error up and down. Where
%   points have several starts, every attractor is drawn once, in a colour of its own.
%   WHIRL_PLOT_LYAPUNOV(RESULT, 'table', NAME) draws that table, and not the first with exponents.
%
%   Gives the handles of the marks of every regime or attractor in the order of the legend, and in a second column
%   those of their bars.
%
%   See also WHIRL_PLOT_BIFURCATION.
FIELD = field_names();
[places, options] = arguments_of(varargin, {}, struct('table', [])); %#ok<ASGLU>
subject = subject_of(result, FIELD.lyapunov_largest, 'lyapunov', options.table, []);
exponent = field_of(subject.table, FIELD.lyapunov_largest);
error_size = field_of(subject.table, FIELD.lyapunov_error);
once = points_once(subject.table, subject.name);
kinds = kinds_of(subject.table, subject.name, has_attractors(subject.table, subject.name));
named = ~isempty(kinds);
if ~named
    kinds = struct('of', ones(size(exponent)), 'number', 1, 'colours', [0, 0, 0]);
end
[axes_handle, held] = begin_figure();
zero = guide_line(axes_handle, subject.values([1, end]), [0, 0], '-');
handle = [];
for i = 1:numel(kinds.number)
    own = once(kinds.of(once) == kinds.number(i));
    rgb = kinds.colours(i, :);
    bars = vertical_lines(axes_handle, subject.values(own), exponent(own) - error_size(own), ...
        exponent(own) + error_size(own), rgb, 0.75);
    marks = draw_marks(axes_handle, subject.values(own), exponent(own), 'o', mark_size(numel(once)), rgb);
    handle = [handle; marks, bars]; %#ok<AGROW>
end
pad_values(axes_handle, subject.values);
limits = get(axes_handle, 'XLim');
set(zero, 'XData', limits);
above_zero(axes_handle);
if named
    kinds_legend(axes_handle, kinds, 'o', [subject.values(once); limits(:)], [exponent(once); 0; 0]);
end
end_figure(axes_handle, held, subject.label, 'largest exponent (1/revolution)');
end

function above_zero(axes_handle)
% The line at 0 is seen where all exponents are below it, or above.
limits = get(axes_handle, 'YLim');
room = 0.05 * diff(limits);
set(axes_handle, 'YLim', [min(limits(1), -room), max(limits(2), room)]);
end
