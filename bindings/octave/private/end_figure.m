function end_figure(axes_handle, held, x_label, y_label, heading)
% END_FIGURE  Labels and a box for the axes, which are held as before. Labels are texts: no letter means an index.
set(axes_handle, 'Box', 'on', 'Layer', 'top');
xlabel(axes_handle, x_label, 'Interpreter', 'none');
ylabel(axes_handle, y_label, 'Interpreter', 'none');
if nargin > 4 && ~isempty(heading)
    title(axes_handle, heading, 'Interpreter', 'none', 'FontWeight', 'normal');
end
if ~held
    hold(axes_handle, 'off');
end
end
