function [axes_handle, held] = begin_figure()
% BEGIN_FIGURE  The current axes, cleared unless they are held, and whether they were.
axes_handle = newplot();
held = ishold(axes_handle);
if ~held && isappdata(axes_handle, 'whirl_place')
    % A colour bar that was there had narrowed them.
    place = getappdata(axes_handle, 'whirl_place');
    set(axes_handle, place{:});
    rmappdata(axes_handle, 'whirl_place');
end
hold(axes_handle, 'on');
end
