function handle = whirl_plot_shares(result, varargin)
% WHIRL_PLOT_SHARES  Draws which share of several starts leads to each attractor, over the parameter.
%   WHIRL_PLOT_SHARES(RESULT) draws the shares in percent, with bars of one standard error up and down. Open circles at
%   0 are attractors that were found from a neighbour alone: none of the place's own starts leads there.
%   WHIRL_PLOT_SHARES(RESULT, 'table', NAME) draws that table, and not the first with several starts.
%
%   Gives the handles of the marks of every attractor: in the first column of those with a share, in the second of open
%   circles, in the third of the bars.
%
%   See also WHIRL_PLOT_BIFURCATION, WHIRL_PLOT_MAP.
FIELD = field_names();
[places, options] = arguments_of(varargin, {}, struct('table', [])); %#ok<ASGLU>
subject = subject_of(result, FIELD.starts_number, '''starts: {count: ..., within: ...}''', options.table, []);
attractor = double(flat(subject.table, subject.table.attractor));
share = 100 * flat(subject.table, subject.table.share);
error_size = 100 * flat(subject.table, subject.table.share_error);
once = points_once(subject.table, subject.name);
once = once(attractor(once) > 0 & ~isnan(share(once)));
kinds = kinds_of(subject.table, subject.name, true);
kept = ismember(kinds.number, attractor(once));
kinds.number = kinds.number(kept);
kinds.colours = kinds.colours(kept, :);
kinds.names = kinds.names(kept);
[axes_handle, held] = begin_figure();
points = max(3, mark_size(numel(once)));
handle = [];
for i = 1:numel(kinds.number)
    own = once(attractor(once) == kinds.number(i));
    reached = own(share(own) > 0);
    found = own(share(own) == 0);
    rgb = kinds.colours(i, :);
    bars = vertical_lines(axes_handle, subject.values(reached), share(reached) - error_size(reached), ...
        share(reached) + error_size(reached), rgb, 0.75);
    marks = draw_marks(axes_handle, subject.values(reached), share(reached), 'o', points, rgb);
    open_marks = draw_marks(axes_handle, subject.values(found), share(found), 'o', points, rgb, false);
    handle = [handle; marks, open_marks, bars]; %#ok<AGROW>
end
set(axes_handle, 'YLim', [-5, 105]);
pad_values(axes_handle, subject.values);
kinds_legend(axes_handle, kinds, 'o', subject.values(once), share(once));
end_figure(axes_handle, held, subject.label, 'share of the starts (%)');
end
