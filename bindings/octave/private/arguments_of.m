function [places, options] = arguments_of(arguments, places, options)
% ARGUMENTS_OF  Divides arguments into values by their places and options, which are pairs of a name and a value.
%   PLACES and OPTIONS have the default values. The first text that is the name of an option ends the places; [] in a
%   place leaves the default value.
names = fieldnames(options);
arguments = cellfun(@text_of, arguments, 'UniformOutput', false);
at = 1;
while at <= numel(arguments) && at <= numel(places) && ~is_one_of(arguments{at}, names)
    if ~isempty(arguments{at})
        places{at} = arguments{at};
    end
    at = at + 1;
end
for i = at:2:numel(arguments)
    if ~is_one_of(arguments{i}, names)
        error('whirl:badInput', 'argument %d is no option, expected one of: %s', i + 1, ...
            strtrim(sprintf('%s ', names{:})));
    end
    if i == numel(arguments)
        error('whirl:badInput', 'the option ''%s'' has no value', arguments{i});
    end
    options.(arguments{i}) = arguments{i + 1};
end
end

function yes = is_one_of(argument, names)
yes = is_text(argument) && any(strcmp(argument, names));
end
