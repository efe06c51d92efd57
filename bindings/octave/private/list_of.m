function items = list_of(decoded)
% LIST_OF  Returns the objects of a JSON array as a list: jsondecode makes a struct array of objects with the same keys.
if iscell(decoded)
    items = decoded(:);
else
    items = num2cell(decoded(:));
end
end
