function label = parameter_label(result, name)
% PARAMETER_LABEL  What the axis of a parameter is called: 'omega (rpm)'; 'point' where nothing varies.
[ignored, unit] = parameter_unit(result, name); %#ok<ASGLU>
label = name;
if isempty(name)
    label = 'point';
elseif ~isempty(unit)
    label = [name ' (' unit ')'];
end
end
