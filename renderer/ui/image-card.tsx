import { Icon } from './icon.tsx';

interface ImageCardProps {
  /** Prefix of the accessible name, which replaces the visual context. */
  readonly purpose?: string;
  readonly title: string;
  readonly text?: string;
  readonly image: string | undefined;
  readonly disabled: boolean;
  readonly onPress: () => void;
}

/** A button with an image and title that opens a project or template. */
export function ImageCard({ purpose, title, text, image, disabled, onPress }: ImageCardProps) {
  return (
    <button type="button" className="image-card" disabled={disabled} onClick={onPress}>
      {image === undefined ? (
        <span className="image-card-none">
          <Icon name="image" size={24} />
        </span>
      ) : (
        <img src={image} alt="" width={240} height={180} draggable={false} />
      )}
      <span className="image-card-title">
        {purpose !== undefined && <span className="visually-hidden">{purpose}: </span>}
        {title}
      </span>
      {text !== undefined && <span className="image-card-text">{text}</span>}
    </button>
  );
}
